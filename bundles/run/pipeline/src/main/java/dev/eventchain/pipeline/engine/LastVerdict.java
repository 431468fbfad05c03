package dev.eventchain.pipeline.engine;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.RunContext;
import java.io.IOException;
import java.util.Optional;

/** The verdict in the output folder, for a run that simulates nothing. */
final class LastVerdict {

  private static final ObjectMapper JSON = new ObjectMapper();

  private LastVerdict() {}

  /** Returns the finding that a simulation did not pass; empty if it did, or there was none. */
  static Optional<Diagnostic> notPassed(RunContext run) {
    return run.output().read(SimulateStage.VERDICT).flatMap(bytes -> notPassed(run, bytes));
  }

  private static Optional<Diagnostic> notPassed(RunContext run, byte[] bytes) {
    JsonNode verdict = parse(bytes);
    JsonNode scenarios = verdict.path("scenarios");
    if (scenarios.isEmpty() || verdict.path("passed").asBoolean(true)) {
      return Optional.empty();
    }
    int passed = 0;
    for (JsonNode scenario : scenarios) {
      passed += scenario.path("passed").asBoolean() ? 1 : 0;
    }
    String counted = passed + " of " + Coverage.counted(scenarios.size(), "scenario");
    return Optional.of(
        Diagnostic.of(
                EngineRules.VERDICT_FAILED,
                "The last simulation did not pass (" + counted + " passed). Its report stays.",
                SourceLocation.of(run.file(SimulateStage.VERDICT)))
            .withHint("Run '" + run.command("") + "' for a verdict about the current files."));
  }

  private static JsonNode parse(byte[] bytes) {
    try {
      return JSON.readTree(bytes);
    } catch (IOException e) {
      return JSON.missingNode(); // as without a verdict, which the caller refuses
    }
  }

  /** Returns the finding that no passed verdict is about the current files. */
  static Diagnostic outdated(RunContext run) {
    return Diagnostic.of(
            EngineRules.STAGE_OUTDATED,
            "There is no verdict about the current files that a report could show.",
            SourceLocation.of(run.file(SimulateStage.VERDICT)))
        .withHint("Run '" + run.command("--from simulate") + "'.");
  }
}
