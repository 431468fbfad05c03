package dev.eventchain.cli.console;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;

/**
 * Writes progress: on a terminal one line per stage, updated while the stage runs; elsewhere one
 * line after each stage.
 */
public final class ProgressLines implements Progress {

  private static final String CLEAR_LINE = "\r\u001b[K";
  private static final int TITLE_WIDTH = 10;

  private final PrintWriter err;
  private final Terminal terminal;

  public ProgressLines(PrintWriter err, Terminal terminal) {
    this.err = err;
    this.terminal = terminal;
  }

  @Override
  public void started(Stage stage) {
    step(stage, stage.purpose());
  }

  @Override
  public void step(Stage stage, String message) {
    if (terminal.live()) {
      err.print(CLEAR_LINE + fit("  " + padded(stage) + " " + oneLine(message) + " ..."));
      err.flush();
    }
  }

  @Override
  public void ended(Stage stage, Status status, Duration duration, String details) {
    if (status == Status.NOT_RUN) {
      return;
    }
    String line = mark(status) + " " + padded(stage) + " " + time(duration) + "  ";
    String text = fit(line + (status == Status.UNCHANGED ? "unchanged: " : "") + oneLine(details));
    err.println((terminal.live() ? CLEAR_LINE : "") + colored(status, text.stripTrailing()));
    err.flush();
  }

  private String mark(Status status) {
    return switch (status) {
      case DONE -> "✓";
      case UNCHANGED -> "=";
      case FAILED -> "✗";
      case WAITING -> "…";
      case NOT_RUN -> " ";
    };
  }

  private String colored(Status status, String text) {
    if (!terminal.color()) {
      return text;
    }
    int color =
        switch (status) {
          case DONE -> 32;
          case FAILED -> 31;
          case WAITING -> 33;
          default -> 2;
        };
    return "\u001b[" + color + "m" + text.substring(0, 1) + "\u001b[0m" + text.substring(1);
  }

  private static String padded(Stage stage) {
    return String.format(Locale.ROOT, "%-" + TITLE_WIDTH + "s", stage.title());
  }

  private static String time(Duration duration) {
    return String.format(Locale.ROOT, "%6.2f s", duration.toNanos() / 1e9);
  }

  private static String oneLine(String text) {
    return Printable.clean(text.replaceAll("[\\t\\n\\r]+", " "));
  }

  private String fit(String text) {
    int columns = terminal.columns() - 1;
    boolean tooLong = terminal.live() && text.length() > columns;
    return tooLong ? text.substring(0, columns - 1) + "…" : text;
  }
}
