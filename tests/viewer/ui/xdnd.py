#!/usr/bin/env python3
"""Drops files on a window, as a file manager does (XDND 5): xdnd.py WINDOW FILE...

Exits with 0 once the window has taken them, with 1 if it does not within ten seconds."""
import sys
import time
from pathlib import Path

from Xlib import X, Xatom, display
from Xlib.protocol import event

connection = display.Display()
target = connection.create_resource_object("window", int(sys.argv[1], 0))
uris = "".join(Path(name).absolute().as_uri() + "\r\n" for name in sys.argv[2:]).encode()
source = connection.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)


def atom(name):
    return connection.intern_atom(name)


def send(name, *data):
    data = (list(data) + [0] * 5)[:5]
    target.send_event(event.ClientMessage(window=target, client_type=atom(name), data=(32, data)))
    connection.flush()


def give(request):
    """Sends the list of files to the requesting window."""
    request.requestor.change_property(request.property, request.target, 8, uris)
    request.requestor.send_event(event.SelectionNotify(
        time=request.time, requestor=request.requestor, selection=request.selection,
        target=request.target, property=request.property))
    connection.flush()


def wait_for(name):
    deadline = time.monotonic() + 10
    while time.monotonic() < deadline:
        while connection.pending_events():
            got = connection.next_event()
            if got.type == X.SelectionRequest:
                give(got)
            if got.type == X.ClientMessage and got.client_type == atom(name):
                return got
        time.sleep(0.01)
    sys.exit(f"{name} does not come")


if target.get_full_property(atom("XdndAware"), Xatom.ATOM) is None:
    sys.exit("the window takes no drops")
source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)
where = target.translate_coords(connection.screen().root, 0, 0)
x, y = 40 - where.x, 40 - where.y
send("XdndEnter", source.id, 5 << 24, atom("text/uri-list"))
send("XdndPosition", source.id, 0, x << 16 | y, X.CurrentTime, atom("XdndActionCopy"))
status = wait_for("XdndStatus")
if not status.data[1][1] & 1:
    sys.exit("the window refuses the drop")
send("XdndDrop", source.id, 0, X.CurrentTime)
wait_for("XdndFinished")
