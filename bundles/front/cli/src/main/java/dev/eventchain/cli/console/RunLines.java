package dev.eventchain.cli.console;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.pipeline.evaluation.LanguageModelEvaluation;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;

/**
 * Writes the progress of an evaluation: a line for each finished run, and on a terminal one that is
 * updated during runs.
 */
public final class RunLines implements LanguageModelEvaluation.Listener {

  private static final String CLEAR_LINE = "\r\u001b[K";

  private final PrintWriter err;
  private final Terminal terminal;

  public RunLines(PrintWriter err, Terminal terminal) {
    this.err = err;
    this.terminal = terminal;
  }

  @Override
  public synchronized void step(String model, int run, String message) {
    if (terminal.live()) {
      err.print(CLEAR_LINE + fit("  " + name(model, run) + "  " + message + " ..."));
      err.flush();
    }
  }

  @Override
  public synchronized void ended(
      String model, int run, boolean counted, Duration duration, String words) {
    String line =
        String.format(
            Locale.ROOT,
            "%s %s %6.2f s  %s",
            counted ? "\u2713" : "-",
            name(model, run),
            duration.toNanos() / 1e9,
            words);
    err.println((terminal.live() ? CLEAR_LINE : "") + fit(line));
    err.flush();
  }

  private static String name(String model, int run) {
    return model + " run " + run;
  }

  private String fit(String text) {
    String line = Printable.line(text);
    int columns = terminal.columns() - 1;
    boolean tooLong = terminal.live() && line.length() > columns;
    return tooLong ? line.substring(0, columns - 1) + "\u2026" : line;
  }
}
