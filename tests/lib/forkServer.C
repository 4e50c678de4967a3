/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Preloaded into a program (LD_PRELOAD, see launcher.py), starts it when its
    libraries are loaded and initialised, and then runs its main in a fork for
    each request on standard input: most of a short run is that loading.

    A fork ends without the destructors of what its libraries hold: freeing
    pages that it shares with the server would cost it half of a short run.

    A request is one line "size" and so many bytes: strings that end with a
    zero, the folder, the log (appended to), "session" or "", and the command's
    words. Answers on standard output are the fork's pid, then its wait status
    and its seconds of one core. The end of standard input is the end.

\*---------------------------------------------------------------------------*/

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

typedef int mainFunction(int, char**, char**);

mainFunction* programMain;

//- Standard input, output and error of a fork
void redirect(const char* log)
{
    const int in = open("/dev/null", O_RDONLY);
    const int out = open(log, O_WRONLY | O_CREAT | O_APPEND, 0666);
    if (in < 0 || out < 0)
    {
        _exit(127);
    }
    dup2(in, 0);
    dup2(out, 1);
    dup2(out, 2);
    close(in);
    close(out);
}

//- The program in its folder; words: folder, log, session and its command
[[noreturn]] void runProgram(std::vector<char*> words)
{
    if (*words[2])
    {
        setsid();
    }
    redirect(words[1]);
    if (chdir(words[0]) != 0)
    {
        _exit(127);
    }
    setenv("PWD", words[0], 1);
    words.erase(words.begin(), words.begin() + 3);
    const int n = int(words.size());
    words.push_back(nullptr);
    exit(programMain(n, words.data(), environ));
}

int serve(int, char**, char**)
{
    unsetenv("LD_PRELOAD");
    unsetenv("LD_BIND_NOW");
    setvbuf(stdin, nullptr, _IONBF, 0);
    size_t size;
    while (scanf("%zu%*1[\n]", &size) == 1)
    {
        std::string text(size, 0);
        if (fread(text.data(), 1, size, stdin) != size)
        {
            break;
        }
        const pid_t pid = fork();
        if (pid == 0)
        {
            std::vector<char*> words;
            for (size_t at = 0; at < size; at = text.find('\0', at) + 1)
            {
                words.push_back(&text[at]);
            }
            runProgram(words);
        }
        dprintf(1, "%d\n", int(pid));
        int status = 0;
        rusage used{};
        wait4(pid, &status, 0, &used);
        const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * t.tv_usec; };
        dprintf(1, "%d %.6f\n", status, seconds(used.ru_utime) + seconds(used.ru_stime));
    }
    _exit(0);
}

} // namespace

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

extern "C" void exit(int status)
{
    std::cout.flush();
    std::cerr.flush();
    fflush(nullptr);
    _exit(status);
}

//- The C library calls this of a program with its main
extern "C" int __libc_start_main(
    mainFunction* program, int argc, char** argv, void (*init)(), void (*fini)(),
    void (*loaderFini)(), void* stackEnd)
{
    programMain = program;
    typedef int start(mainFunction*, int, char**, void (*)(), void (*)(), void (*)(), void*);
    const auto real = reinterpret_cast<start*>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return real(&serve, argc, argv, init, fini, loaderFini, stackEnd);
}

// ************************************************************************* //
