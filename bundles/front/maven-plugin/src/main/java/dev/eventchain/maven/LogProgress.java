package dev.eventchain.maven;

import dev.eventchain.diagnostics.Printable;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import java.time.Duration;
import java.util.Locale;
import org.apache.maven.plugin.logging.Log;

/** Writes a line of Maven's log for each finished stage. */
final class LogProgress implements Progress {

  private final Log log;

  LogProgress(Log log) {
    this.log = log;
  }

  @Override
  public void started(Stage stage) {
    log.debug(stage.title() + ": " + stage.purpose());
  }

  @Override
  public void step(Stage stage, String message) {
    log.debug(stage.title() + ": " + Printable.line(message));
  }

  @Override
  public void ended(Stage stage, Status status, Duration duration, String details) {
    if (status != Status.NOT_RUN) {
      log.info(
          String.format(
              Locale.ROOT,
              "%-10s %-9s %6.2f s  %s",
              stage.title(),
              status,
              duration.toNanos() / 1e9,
              Printable.line(details)));
    }
  }
}
