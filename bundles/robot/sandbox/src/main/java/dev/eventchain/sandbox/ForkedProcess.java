package dev.eventchain.sandbox;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** A process that a {@link Template} has forked, which is no child of this JVM. */
final class ForkedProcess extends Process {

  private final ProcessHandle handle;
  private final OutputStream stdin;
  private final InputStream stdout;
  private final InputStream stderr;
  private final CompletableFuture<Integer> exit = new CompletableFuture<>();

  /**
   * Opens the streams of a process that has not ended.
   *
   * @param folder the descriptors of the template, {@code /proc/ID/fd}
   * @param descriptors those of the other ends of standard input, output and error
   */
  ForkedProcess(long pid, String folder, int... descriptors) throws IOException {
    handle = ProcessHandle.of(pid).orElseThrow(() -> new IOException("it has ended"));
    stdin = new BufferedOutputStream(new FileOutputStream(folder + descriptors[0]));
    stdout = new BufferedInputStream(new FileInputStream(folder + descriptors[1]));
    stderr = new BufferedInputStream(new FileInputStream(folder + descriptors[2]));
  }

  /** Takes note of its end. */
  void ended(int exitCode) {
    exit.complete(exitCode);
  }

  @Override
  public OutputStream getOutputStream() {
    return stdin;
  }

  @Override
  public InputStream getInputStream() {
    return stdout;
  }

  @Override
  public InputStream getErrorStream() {
    return stderr;
  }

  @Override
  public int waitFor() throws InterruptedException {
    try {
      return exit.get();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e); // it is only ever completed with a code
    }
  }

  @Override
  public boolean waitFor(long timeout, TimeUnit unit) throws InterruptedException {
    try {
      int unused = exit.get(timeout, unit);
      return true;
    } catch (TimeoutException e) {
      return false;
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public int exitValue() {
    if (!exit.isDone()) {
      throw new IllegalThreadStateException("it has not ended");
    }
    return exit.join();
  }

  @Override
  public boolean isAlive() {
    return !exit.isDone();
  }

  @Override
  public CompletableFuture<Process> onExit() {
    return exit.thenApply(code -> this);
  }

  @Override
  public ProcessHandle toHandle() {
    return handle;
  }

  @Override
  public long pid() {
    return handle.pid();
  }

  @Override
  public void destroy() {
    handle.destroy();
  }

  @Override
  public Process destroyForcibly() {
    handle.destroyForcibly();
    return this;
  }
}
