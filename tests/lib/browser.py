"""Chromium without a screen, driven over its DevTools protocol (by a pipe).

    with Browser("/tmp/profile") as browser:
        page = browser.open("report.html", 1400, 900)
        page.evaluate("document.title")
        page.key("ArrowLeft")
        page.drag((100, 200), (300, 200))
        page.screenshot("page.png")
        page.errors                                 # what the console has of errors

Browser.find() is the program, None if there is none here. A browser that ends or does not
answer is BrowserLost; inBrowser() then begins anew.
"""

import base64
import fcntl
import json
import os
import re
import select
import shutil
import subprocess
import time

from report import Report

#: Seconds for an answer
PATIENCE = 60

#: Browsers that inBrowser() may start
ATTEMPTS = 3


class BrowserLost(Exception):
    """The browser, not a page of it, has failed."""


class Navigated(Exception):
    """The page went elsewhere while it was asked."""


def inBrowser(table, profile, work):
    """Rows of work(table, browser). Where the browser is lost on the way, all of them are made
    anew with another one; what a page does wrong is no reason."""
    for attempt in range(1, ATTEMPTS + 1):
        held = Report(table.case, held=True)
        try:
            with Browser(profile) as browser:
                work(held, browser)
            break
        except BrowserLost as e:
            print(f"attempt {attempt}: {e}", flush=True)
            if attempt == ATTEMPTS:
                raise
    table.take(held)


class Browser:
    @staticmethod
    def find():
        return next(filter(None, map(shutil.which, (
            "chromium", "chromium-browser", "google-chrome"))), None)

    def __init__(self, profile):
        shutil.rmtree(profile, ignore_errors=True)
        read, self.out = os.pipe()
        self.input, write = os.pipe()

        def ends():
            # The two ends that the protocol wants, of copies above both: any may be one of them
            a, b = (fcntl.fcntl(end, fcntl.F_DUPFD, 5) for end in (read, write))
            os.dup2(a, 3)
            os.dup2(b, 4)
        self.process = subprocess.Popen(
            [self.find(), "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
             "--disable-dev-shm-usage", "--disable-extensions", "--disable-background-networking",
             f"--user-data-dir={profile}", "--remote-debugging-pipe", "about:blank"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            close_fds=False, preexec_fn=ends)
        os.close(read)
        os.close(write)
        self.number, self.rest, self.pages = 0, b"", {}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self.out)
        os.close(self.input)

    def message(self, until):
        """The next message; BrowserLost if there is none."""
        while b"\0" not in self.rest:
            if not select.select([self.input], [], [], max(0, until - time.time()))[0]:
                raise BrowserLost("the browser does not answer")
            got = os.read(self.input, 1 << 20)
            if not got:
                raise BrowserLost("the browser has ended")
            self.rest += got
        one, self.rest = self.rest.split(b"\0", 1)
        return json.loads(one)

    def call(self, method, session=None, **parameters):
        """The result of a method; what happens meanwhile goes to its page."""
        self.number += 1
        text = {"id": self.number, "method": method, "params": parameters}
        if session:
            text["sessionId"] = session
        try:
            os.write(self.out, json.dumps(text).encode() + b"\0")
        except BrokenPipeError as e:
            raise BrowserLost("the browser has ended") from e
        until = time.time() + PATIENCE
        while True:
            answer = self.message(until)
            if answer.get("id") == self.number:
                if re.search("context|navigated", answer.get("error", {}).get("message", "")):
                    raise Navigated(f"{method}: {answer['error']}")
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            if answer.get("method") == "Inspector.targetCrashed":
                raise BrowserLost("a page of the browser has crashed")
            page = self.pages.get(answer.get("sessionId"))
            if page and "method" in answer:
                page.happened(answer["method"], answer["params"])

    def open(self, path, width, height):
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        session = self.call("Target.attachToTarget", targetId=target,
                            flatten=True)["sessionId"]
        self.pages[session] = page = Page(self, session)
        for domain in ("Page", "Runtime", "Log", "Network", "Inspector"):
            page.call(f"{domain}.enable")
        page.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)
        page.call("Page.navigate", url="file://" + os.path.abspath(path))
        page.wait("location.protocol === 'file:' && document.readyState === 'complete'")
        return page


class Page:
    def __init__(self, browser, session):
        self.browser, self.session = browser, session
        self.errors, self.requests = [], []

    def call(self, method, **parameters):
        return self.browser.call(method, self.session, **parameters)

    def happened(self, method, data):
        if method == "Runtime.exceptionThrown":
            self.errors.append(json.dumps(data["exceptionDetails"])[:300])
        elif method == "Runtime.consoleAPICalled" and data["type"] in ("error", "warning"):
            self.errors.append(json.dumps(data["args"])[:300])
        elif method == "Log.entryAdded" and data["entry"]["level"] in ("error", "warning"):
            self.errors.append(data["entry"]["text"][:300])
        elif method == "Network.requestWillBeSent":
            self.requests.append(data["request"]["url"][:200])

    def evaluate(self, text):
        result = self.call("Runtime.evaluate", expression=text, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{text}: {json.dumps(result['exceptionDetails'])[:500]}")
        return result["result"].get("value")

    def wait(self, condition):
        until = time.time() + PATIENCE
        while True:
            try:
                if self.evaluate(condition):
                    return
            except Navigated:
                pass
            if time.time() > until:
                raise TimeoutError(f"never true: {condition}")
            time.sleep(0.05)

    def key(self, name, text=""):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name,
                      text=text if kind == "keyDown" else "",
                      windowsVirtualKeyCode={"ArrowLeft": 37, "ArrowRight": 39, "Home": 36,
                                             "End": 35}.get(name, 0))

    def mouse(self, kind, at, clicks=1, button="left"):
        self.call("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button=button,
                  buttons=1 if button == "left" and kind != "mouseReleased" else 0,
                  clickCount=clicks)

    def drag(self, start, end):
        self.mouse("mouseMoved", start, button="none")
        self.mouse("mousePressed", start)
        for part in (0.3, 0.7, 1.0):
            self.mouse("mouseMoved", [a + part*(b - a) for a, b in zip(start, end)])
        self.mouse("mouseReleased", end)

    def doubleClick(self, at):
        for clicks in (1, 2):
            self.mouse("mousePressed", at, clicks)
            self.mouse("mouseReleased", at, clicks)

    def screenshot(self, path, whole=False):
        if whole:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            self.call("Emulation.setDeviceMetricsOverride", width=size["width"],
                      height=min(int(size["height"]) + 1, 8000), deviceScaleFactor=1,
                      mobile=False)
            time.sleep(1)
        data = self.call("Page.captureScreenshot", format="png")["data"]
        with open(path, "wb") as f:
            f.write(base64.b64decode(data))
