package dev.eventchain.mcp.program;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * The command line, one process for each command.
 *
 * @param start what starts it: the words before its arguments
 */
public record Program(List<String> start) {

  private static final int LARGEST_OUTPUT = 4 << 20;
  private static final File NOTHING = new File("/dev/null");

  /** As wide as a message may be, so that none is cut. */
  private static final String COLUMNS = "999";

  public Program {
    start = List.copyOf(start);
  }

  /**
   * Runs a command to its end, or until its call is cancelled: then as by SIGTERM, which leaves
   * every file as it was or complete.
   *
   * @param folder the working folder
   * @param progress gets each message about the progress
   * @throws UncheckedIOException if it cannot be started
   */
  public Ended run(
      List<String> arguments, Path folder, RunningCall call, Consumer<String> progress) {
    List<String> command = new ArrayList<>(start);
    command.addAll(arguments);
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    // A line that is updated in place says more than the lines that stay.
    builder.environment().put("EVENTCHAIN_TERMINAL_COLUMNS", COLUMNS);
    builder.environment().put("NO_COLOR", "1");
    builder.environment().put("TERM", "xterm");
    // The streams of the server are those of the protocol: no other process may have them.
    builder.redirectInput(ProcessBuilder.Redirect.from(NOTHING));
    try {
      Process process = call.start(builder);
      CompletableFuture<String> out =
          CompletableFuture.supplyAsync(() -> text(process.getInputStream()));
      ProgressText err = new ProgressText(progress);
      try (Reader reader = reader(process.getErrorStream())) {
        err.readAll(reader);
      }
      return new Ended(process.waitFor(), out.join(), err.lines());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  private static Reader reader(InputStream stream) {
    return new InputStreamReader(stream, StandardCharsets.UTF_8);
  }

  /** Reads to the end, and keeps as much as may be an answer. */
  private static String text(InputStream stream) {
    StringBuilder text = new StringBuilder();
    try (Reader reader = reader(stream)) {
      char[] buffer = new char[8192];
      for (int read = reader.read(buffer); read >= 0; read = reader.read(buffer)) {
        text.append(buffer, 0, Math.min(read, LARGEST_OUTPUT - text.length()));
      }
      return text.toString();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
