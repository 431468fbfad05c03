package dev.eventchain.pipeline.measure;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.tracing.RecordedTrace;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Traces as babeltrace2 writes them: its text in a file, or a folder in the Common Trace Format, on
 * which it is started.
 */
final class Babeltrace {

  private static final int MOST_OF_MESSAGE = 300;

  private Babeltrace() {}

  /**
   * Reads a trace.
   *
   * @param program the command that starts babeltrace2
   * @throws DiagnosticException INPUT if it is none, UNAVAILABLE if there is no babeltrace2
   */
  static RecordedTrace read(Path trace, List<String> program) {
    if (Files.isDirectory(trace)) {
      return readFolder(trace, program);
    }
    try (BufferedReader text = Files.newBufferedReader(trace, StandardCharsets.UTF_8)) {
      return RecordedTrace.read(text, SourceLocation.of(trace));
    } catch (IOException e) {
      throw RecordedTrace.unreadable(SourceText.reason(e), SourceLocation.of(trace));
    }
  }

  private static RecordedTrace readFolder(Path folder, List<String> program) {
    List<String> command = new ArrayList<>(program);
    command.addAll(RecordedTrace.OPTIONS);
    command.add(folder.toAbsolutePath().toString());
    Path errors = null;
    Process process = null;
    try {
      errors = Files.createTempFile("eventchain-trace-", ".log");
      process = start(command, errors, folder);
      process.getOutputStream().close();
      try (BufferedReader text = process.inputReader(StandardCharsets.UTF_8)) {
        return read(text, process, errors, folder);
      }
    } catch (IOException e) {
      throw RecordedTrace.unreadable(SourceText.reason(e), SourceLocation.of(folder));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    } finally {
      end(process, errors);
    }
  }

  /** Reads what babeltrace2 writes; if it fails, its own reason is the one to be told. */
  private static RecordedTrace read(BufferedReader text, Process process, Path errors, Path folder)
      throws IOException, InterruptedException {
    RecordedTrace read = null;
    DiagnosticException refused = null;
    try {
      read = RecordedTrace.read(text, SourceLocation.of(folder));
    } catch (DiagnosticException e) {
      if (text.read() >= 0) {
        throw e;
      }
      refused = e;
    }
    int code = process.waitFor();
    if (code != 0) {
      throw RecordedTrace.unreadable(
          String.format(Locale.ROOT, "babeltrace2 ended with exit code %d: %s", code, last(errors)),
          SourceLocation.of(folder));
    }
    if (refused != null) {
      throw refused;
    }
    return read;
  }

  private static Process start(List<String> command, Path errors, Path folder) {
    try {
      return new ProcessBuilder(command).redirectError(errors.toFile()).start();
    } catch (IOException e) {
      throw new DiagnosticException(
          Reason.UNAVAILABLE,
          Diagnostic.of(
                  MeasureRules.TRACE_READER,
                  "There is no babeltrace2, which reads the folder of a trace.",
                  SourceLocation.of(folder))
              .withHint(
                  "Install it (apt-get install babeltrace2), or run it where it is and name the file: babeltrace2 "
                      + String.join(" ", RecordedTrace.OPTIONS)
                      + " FOLDER > trace.txt"));
    }
  }

  private static String last(Path errors) throws IOException {
    String text = Files.readString(errors, StandardCharsets.ISO_8859_1).strip();
    return Printable.line(text.substring(Math.max(0, text.length() - MOST_OF_MESSAGE)));
  }

  private static void end(Process process, Path errors) {
    if (process != null && process.isAlive()) {
      process.destroyForcibly();
    }
    if (errors != null && !errors.toFile().delete()) {
      errors.toFile().deleteOnExit();
    }
  }
}
