package dev.eventchain.simulation.host;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.sandbox.ConfinedProcess;
import java.time.Duration;
import java.util.List;
import java.util.function.Supplier;

/**
 * Failures in a process that runs nodes, as findings that point to the location in the user's code,
 * if known.
 *
 * @param who the process, for users, as the subject of a sentence
 * @param lastWords ends the process and returns how it ended
 * @param files translates the file names of the process into those of the user
 */
public record HostFailures(String who, Supplier<LastWords> lastWords, UserFiles files) {

  private static final int LAST_LINES = 12;

  /** Time in which a process whose output has ended should be gone, so that its exit code is. */
  private static final Duration PATIENCE = Duration.ofSeconds(1);

  /** Difference between an exit code and the signal that ended the process. */
  private static final int SIGNALS = 128;

  /** The greatest number of a signal on Linux. */
  private static final int LAST_SIGNAL = 64;

  /**
   * Cause and error output of an ended process.
   *
   * @param termination how it ended
   * @param standardError its output on standard error
   */
  public record LastWords(ConfinedProcess.Termination termination, String standardError) {

    /** Ends a process and returns its cause and error output. */
    public static LastWords of(ConfinedProcess process) {
      ConfinedProcess.Termination termination = process.awaitOrKill(PATIENCE);
      return new LastWords(termination, process.standardError());
    }

    /** Returns how it ended, as the end of a sentence; empty if it was ended. */
    private String how() {
      if (termination.cause() != ConfinedProcess.Cause.EXITED) {
        return "";
      }
      int code = termination.exitCode();
      return code > SIGNALS && code <= SIGNALS + LAST_SIGNAL
          ? ", by signal " + (code - SIGNALS)
          : ", with the exit code " + code;
    }
  }

  /** Creates the exception for a reported failure in the user's code. */
  public DiagnosticException failed(JsonNode failure) {
    return finding(inUserCode(failure, files));
  }

  /** Creates the finding for a failure in the user's code. */
  public static Diagnostic inUserCode(JsonNode failure, UserFiles files) {
    String node = failure.path("node").asText("");
    String message = Printable.line(failure.path("message").asText(""));
    SourceLocation location =
        new SourceLocation(
            files.name(failure.path("file").asText("")),
            failure.path("line").asInt(0),
            failure.path("column").asInt(0),
            node,
            failure.path("excerpt").asText(""));
    String text = node.isEmpty() ? message : "Node " + node + ": " + message;
    String id = failure.path("id").asText(HostRules.NODE_FAILED.id());
    return Diagnostic.of(HostRules.find(id).orElseGet(() -> Rule.error(id)), text, location)
        .withHint(failure.path("hint").asText(""));
  }

  /**
   * Creates the exception for a process that has ended, or was ended.
   *
   * @param usedUp the exceeded time limit for an answer, if it was ended for that; else empty
   */
  public DiagnosticException ended(String usedUp) {
    LastWords last = lastWords.get();
    if (!usedUp.isEmpty()) {
      String message = "The nodes did not answer within " + usedUp + " and were ended.";
      return finding(
          Diagnostic.of(HostRules.SIMULATION_STEP_TIMEOUT, message, files.folder())
              .withHint("Look for an endless loop or a wait in a node."));
    }
    return switch (last.termination().cause()) {
      case OUTPUT ->
          ended(HostRules.SIMULATION_LIMIT, "The nodes write to standard error endlessly.", last);
      case WALL_TIME, CPU_TIME ->
          ended(HostRules.SIMULATION_RUN_TIMEOUT, "The simulation took longer than allowed.", last);
      default ->
          ended(
              HostRules.SIMULATION_PROCESS_ENDED,
              who + " ended before the scenario did" + last.how() + ".",
              last);
    };
  }

  private DiagnosticException ended(Rule rule, String message, LastWords last) {
    return finding(Diagnostic.of(rule, message, files.folder()).withHint(text(last)));
  }

  /** Creates the exception for a violation of the protocol. */
  public DiagnosticException garbage(String what) {
    String message = who + " sent " + what + ".";
    return finding(
        Diagnostic.of(HostRules.SIMULATION_PROTOCOL, message, files.folder())
            .withHint(text(lastWords.get())));
  }

  private static String text(LastWords words) {
    List<String> lines = words.standardError().lines().toList();
    List<String> last = lines.subList(Math.max(0, lines.size() - LAST_LINES), lines.size());
    return last.isEmpty() ? "It gave no reason." : "Its last output:\n" + String.join("\n", last);
  }

  private static DiagnosticException finding(Diagnostic diagnostic) {
    return new DiagnosticException(DiagnosticException.Reason.FINDINGS, diagnostic);
  }
}
