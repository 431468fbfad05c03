import socket
socket.socketpair()
print("ESCAPED")
