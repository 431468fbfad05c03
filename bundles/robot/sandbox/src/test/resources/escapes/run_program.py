import subprocess
subprocess.run(["/bin/true"], check=True)
print("ESCAPED")
