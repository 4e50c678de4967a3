"use strict";
// The page of mpmReport: a slider for pictures, plots that one can zoom, new reading while
// a run goes on. Its data stand in the script elements of type application/json.
(function () {
  const read = id => JSON.parse(document.getElementById(id).textContent);
  const page = read("page");
  const keep = "mpmReport " + location.pathname;
  let state = {};
  try { state = JSON.parse(sessionStorage.getItem(keep)) || {}; } catch (e) { state = {}; }
  const save = () => {
    try { sessionStorage.setItem(keep, JSON.stringify(state)); } catch (e) { /* not kept */ }
  };

  // --- pictures: one slider for all; a picture shows its last frame up to that time
  const slider = document.getElementById("time");
  if (slider) {
    const shown = document.getElementById("shown");
    const pictures = read("frames");
    const show = () => {
      const i = Number(slider.value), t = page.times[i];
      for (const p of pictures) {
        let k = 0;
        while (k + 1 < p.times.length && p.times[k + 1] <= t * (1 + 1e-9)) ++k;
        const img = document.getElementById(p.id);
        img.src = p.images[k];
        img.alt = p.title + " at " + page.names[i];
      }
      shown.textContent = page.names[i];
      slider.setAttribute("aria-valuetext", page.names[i]);
      state.time = i === page.times.length - 1 ? "last" : i;
      save();
    };
    if (Number.isInteger(state.time) && state.time < page.times.length) {
      slider.value = state.time;
    }
    slider.addEventListener("input", show);
    show();
    const play = document.getElementById("play");
    let timer = null;
    play.addEventListener("click", () => {
      if (timer) {
        clearInterval(timer);
        timer = null;
      } else {
        timer = setInterval(() => {
          slider.value = (Number(slider.value) + 1) % page.times.length;
          show();
        }, 400);
      }
      play.textContent = timer ? "Pause" : "Play";
    });
  }

  // --- plots
  const digits = (v, n) => {
    const a = Math.abs(v), w = Number(v.toPrecision(n));
    return v === 0 || a >= 1e-3 && a < (n > 5 ? 1e8 : 1e5) ? String(w) : String(w.toExponential());
  };
  const number = v => digits(v, 5);
  // Ticks that five digits do not tell apart get more
  const ticker = (a, b, pixels, options, graph, values) => {
    const ticks = Dygraph.numericTicks(a, b, pixels, options, graph, values);
    const shown = ticks.filter(tick => tick.label);
    for (let n = 6; n < 16 && new Set(shown.map(t => t.label)).size < shown.length; ++n) {
      shown.forEach(tick => { tick.label = digits(tick.v, n); });
    }
    return ticks;
  };
  const COLOURS = ["#1b62a5", "#d0701c", "#22763d", "#8a3d96", "#b02a2a", "#0d8a8a", "#8a6d00",
    "#4a4a4a", "#5f7fd0", "#c2568f"];
  // Rows of time and lines; those of another run have times of their own, and gaps between
  const rows = plot => {
    const n = plot.lines.length, found = [];
    plot.lines.forEach((line, k) => {
      const t = plot.t[line.run];
      line.y.forEach((y, i) => found.push([t[i], k, y]));
    });
    found.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const data = [];
    for (const [t, k, y] of found) {
      if (!data.length || data[data.length - 1][0] !== t) {
        data.push([t].concat(Array(n).fill(null)));
      }
      data[data.length - 1][k + 1] = y;
    }
    return data;
  };
  // With another run a colour stands once, the other's lines are dashed; under the cursor all
  // lines that have a value there
  const legend = plot => data => {
    const here = data.x !== undefined, both = plot.t.length > 1;
    const own = new Set(plot.lines.filter(line => line.run === 0).map(line => line.name));
    const shown = data.series.filter((s, k) => here ? s.yHTML :
      !both || own.has(s.label) || !own.has(plot.lines[k].of));
    const words = shown.map(s => `<b style="color: ${s.color}">${here ? "" : s.dashHTML} `
      + `${s.labelHTML}</b>${here ? ": " + s.yHTML : ""}`);
    const dashed = document.createElement("i");
    dashed.textContent = both && !here ? "dashed: " + plot.other : "";
    return (here ? data.xHTML + ": " : "") + words.join(" ") + " " + dashed.outerHTML;
  };
  const graphs = {};
  const draw = (plot, i) => {
    const box = document.getElementById("plot" + i);
    const names = plot.lines.map(line => line.name);
    const own = plot.lines.filter(line => line.run === 0).map(line => line.name);
    const series = {};
    plot.lines.forEach(line => {
      const at = own.indexOf(line.of), k = at < 0 ? own.length : at;
      series[line.name] = {
        color: COLOURS[k % COLOURS.length],
        strokePattern: line.run ? [6, 3] : k >= COLOURS.length ? [2, 2] : null
      };
    });
    const canvas = box.querySelector(".canvas");
    const graph = new Dygraph(canvas, rows(plot), {
      labels: ["time"].concat(names), series: series, labelsDiv: box.querySelector(".legend"),
      legend: "always", legendFormatter: legend(plot), connectSeparatedPoints: true,
      strokeWidth: 1.4, logscale: plot.log,
      xlabel: page.timeLabel, ylabel: plot.axis, xLabelHeight: 17, yLabelWidth: 17,
      axisLabelFontSize: 11, includeZero: false, xRangePad: 4, yRangePad: 8,
      animatedZooms: false, highlightCircleSize: 2.5, gridLineColor: "#e3e8ed",
      axisLineColor: "#8a949e", dateWindow: state["zoom " + plot.id] || null,
      axes: {
        x: {
          ticker: ticker, axisLabelFormatter: number,
          valueFormatter: v => page.timeName + " " + number(v)
        },
        y: {
          ticker: ticker, axisLabelFormatter: number, valueFormatter: number, axisLabelWidth: 98
        }
      },
      drawCallback: (g, first) => {
        box.dataset.from = g.xAxisRange()[0];
        box.dataset.to = g.xAxisRange()[1];
        if (!first) {
          state["zoom " + plot.id] = g.isZoomed("x") ? g.xAxisRange() : undefined;
          save();
        }
      }
    });
    graphs[i] = graph;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", plot.title + ", plot over time; keys + - arrows 0");
    canvas.addEventListener("keydown", e => {
      let [a, b] = graph.xAxisRange();
      const width = b - a;
      if (e.key === "+" || e.key === "=") { a += width / 4; b -= width / 4; }
      else if (e.key === "-") { a -= width / 2; b += width / 2; }
      else if (e.key === "ArrowLeft") { a -= width / 5; b -= width / 5; }
      else if (e.key === "ArrowRight") { a += width / 5; b += width / 5; }
      else if (e.key === "0" || e.key === "Escape") { graph.resetZoom(); e.preventDefault(); return; }
      else return;
      e.preventDefault();
      graph.updateOptions({ dateWindow: [a, b] });
    });
  };
  const plots = read("plots");
  if (typeof Dygraph !== "undefined" && page.zoom) {
    const waiting = new IntersectionObserver(seen => seen.forEach(one => {
      if (one.isIntersecting) {
        waiting.unobserve(one.target);
        const i = Number(one.target.id.slice(4));
        draw(plots[i], i);
      }
    }), { rootMargin: "600px" });
    // Those that are zero all the time have no place
    const boxes = document.querySelectorAll(".plot");
    boxes.forEach(box => waiting.observe(box));
    // On paper all are seen
    window.addEventListener("beforeprint", () => boxes.forEach(box => {
      const i = Number(box.id.slice(4));
      if (!graphs[i] && box.offsetParent) {
        waiting.unobserve(box);
        draw(plots[i], i);
      }
    }));
  }
  window.mpmReport = { graphs: graphs, plots: plots };

  // --- a run that goes on: read the page anew, where it was
  if (page.refresh) {
    const hold = document.getElementById("hold");
    hold.checked = Boolean(state.hold);
    hold.addEventListener("change", () => { state.hold = hold.checked; save(); });
    setInterval(() => { if (!hold.checked) location.reload(); }, 1000 * page.refresh);
  }
})();
