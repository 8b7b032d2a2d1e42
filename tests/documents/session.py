"""A shell and a Python that remember, for the commands of one document."""

import json
import os
import re
import shlex
import signal
import socket
import subprocess
import sys
import time

# Runs blocks that come as lines of JSON in one namespace; answers "" or what failed.
_DRIVER = r"""
import io, json, sys, traceback

answers, sys.stdout = sys.stdout, sys.stderr
names = {"__name__": "__main__"}

def typed(text):
    # Commands behind ">>> ", each with what it prints or raises.
    for part in text.split(">>> ")[1:]:
        command, _, expected = part.partition("\n")
        try:
            printed = repr(eval(command, names))
        except Exception as error:
            kind = type(error)
            printed = f"{kind.__module__}.{kind.__qualname__}: {error}"
        if printed.split() != expected.split():
            return f"{command}\n{printed}\nis not\n{expected}"
    return ""

for line in sys.stdin:
    block = json.loads(line)
    try:
        if block["typed"]:
            answer = typed(block["text"])
        else:
            # Errors then name the line of the document.
            text = "\n" * (block["line"] - 1) + block["text"]
            exec(compile(text, block["document"], "exec"), names)
            answer = ""
    except Exception:
        answer = traceback.format_exc()
    print(json.dumps(answer), file=answers, flush=True)
"""


class Session:
    """`prefix` comes before each command, e.g. ["chroot", "/root"]; `folder`, as
    the commands see it, is where the first one runs; `python` is the program for
    blocks of Python. Use in a `with`."""

    def __init__(self, prefix, environment, folder, python):
        self._prefix = prefix
        self._environment = environment
        self._state = {"PWD": folder, "PATH": environment["PATH"]}
        self._python_program = python
        self._python = None
        self._server = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._end_server()
        if self._python:
            self._python.stdin.close()
            self._python.wait()
            self._python.stdout.close()

    def _words(self, command):
        place = "cd " + shlex.quote(self._state["PWD"]) + " && "
        path = "PATH=" + shlex.quote(self._state["PATH"])
        return self._prefix + ["bash", "-c", f"{path}; {place}{command}"]

    def run(self, command, standard_input=""):
        """What the command printed. Its folder and PATH are those of the next.

        Errors: AssertionError if it fails, with what it printed.
        """
        reader, writer = os.pipe()
        # What follows a command that fails is left out.
        end = f'\nstatus=$?; printf "%s\\n" "$PWD" "$PATH" >&{writer}; exit $status'
        with open(reader, encoding="utf-8") as state:
            done = subprocess.run(self._words(f"{{ {command}\n}}{end}"),
                                  env=self._environment, text=True,
                                  input=standard_input, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, pass_fds=[writer],
                                  check=False)
            os.close(writer)
            self._state["PWD"], self._state["PATH"] = state.read().splitlines()
        sys.stderr.write(done.stderr)
        if done.returncode:
            raise AssertionError(f"{command}: exit code {done.returncode}\n"
                                 f"{done.stdout[-2000:]}{done.stderr[-4000:]}")
        return done.stdout

    def write(self, name, text):
        self.run(f"cat >{shlex.quote(name)}", text)

    def start_server(self, command):
        """Starts what runs until it is told to end: at the next of these, or the
        end. Returns once it listens at all addresses that the command names."""
        self._end_server()
        self._server = subprocess.Popen(self._words(f"exec {command}"),
                                        env=self._environment)
        ports = re.findall(r"127\.0\.0\.1:(\d+)", command)
        end = time.monotonic() + 60
        while ports:
            if self._server.poll() is not None or time.monotonic() > end:
                raise AssertionError(f"{command}: does not serve")
            try:
                socket.create_connection(("127.0.0.1", int(ports[0]))).close()
                ports.pop(0)
            except ConnectionRefusedError:
                time.sleep(0.02)

    def _end_server(self):
        if not self._server:
            return
        self._server.send_signal(signal.SIGTERM)
        status = self._server.wait()
        self._server = None
        if status:
            raise AssertionError(f"the server ended with {status}")

    def run_python(self, document, line, text, typed):
        """A block of Python, after those before it; `typed` if it has prompts.

        Errors: AssertionError if it raises, or prints something else.
        """
        if not self._python:
            command = (f"exec {shlex.quote(self._python_program)} -c "
                       f"{shlex.quote(_DRIVER)}")
            self._python = subprocess.Popen(
                self._words(command), env=self._environment, text=True,
                stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        block = {"document": document, "line": line, "text": text, "typed": typed}
        print(json.dumps(block), file=self._python.stdin, flush=True)
        answer = self._python.stdout.readline()
        if answer != '""\n':
            raise AssertionError(json.loads(answer) if answer else "Python ended")
