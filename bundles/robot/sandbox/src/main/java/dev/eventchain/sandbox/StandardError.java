package dev.eventchain.sandbox;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/** Reads a process's standard error to its end, and keeps the first and last parts. */
final class StandardError {

  private static final int PART = 32 * 1024;
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  private final ByteArrayOutputStream first = new ByteArrayOutputStream();
  private final byte[] last = new byte[PART];
  private long beyond;
  private final long most;
  private final Runnable tooMuch;
  private Thread reader;

  private StandardError(long most, Runnable tooMuch) {
    this.most = most;
    this.tooMuch = tooMuch;
  }

  /**
   * Starts to read a stream.
   *
   * @param most bytes after which {@code tooMuch} is run, once
   */
  static StandardError of(InputStream stream, long most, Runnable tooMuch) {
    StandardError result = new StandardError(most, tooMuch);
    result.reader = ProcessThreads.daemon(() -> result.read(stream), "confined-process-stderr");
    result.reader.start();
    return result;
  }

  private void read(InputStream stream) {
    byte[] buffer = new byte[8192];
    long all = 0;
    try (stream) {
      for (int count = stream.read(buffer); count >= 0; count = stream.read(buffer)) {
        keep(buffer, count);
        if (all <= most && all + count > most) {
          tooMuch.run();
        }
        all += count;
      }
    } catch (IOException e) {
      keep(new byte[0], 0); // the pipe of a killed process: its output is complete
    }
  }

  private synchronized void keep(byte[] buffer, int count) {
    int head = Math.min(count, PART - first.size());
    first.write(buffer, 0, head);
    for (int i = head; i < count; i++) {
      last[(int) (beyond++ % PART)] = buffer[i];
    }
  }

  void await() throws InterruptedException {
    reader.join(PATIENCE.toMillis());
  }

  synchronized String text() {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.writeBytes(first.toByteArray());
    if (beyond > PART) {
      all.writeBytes("\n[...]\n".getBytes(StandardCharsets.UTF_8));
      int start = (int) (beyond % PART);
      all.write(last, start, PART - start);
      all.write(last, 0, start);
    } else {
      all.write(last, 0, (int) beyond);
    }
    return all.toString(StandardCharsets.UTF_8);
  }
}
