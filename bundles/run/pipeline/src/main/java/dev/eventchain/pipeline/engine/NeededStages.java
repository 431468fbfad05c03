package dev.eventchain.pipeline.engine;

import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.StageOutcome;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** What stages work on, where one that fails does not end the others. */
final class NeededStages {
  private static final Map<Stage, List<Stage>> NEEDED =
      new EnumMap<>(
          Map.of(
              Stage.IMPLEMENT, List.of(Stage.DESIGN),
              Stage.MODEL, List.of(Stage.DESIGN),
              Stage.CONSTRAIN, List.of(Stage.DESIGN),
              Stage.VALIDATE, List.of(Stage.MODEL, Stage.CONSTRAIN),
              Stage.GENERATE, List.of(Stage.IMPLEMENT, Stage.VALIDATE),
              Stage.SIMULATE, List.of(Stage.GENERATE)));

  private NeededStages() {}

  /** Whether all that a stage works on was made in this run. */
  static boolean areDone(Stage stage, Map<Stage, StageOutcome> outcomes) {
    return NEEDED.getOrDefault(stage, List.of()).stream()
        .map(outcomes::get)
        .allMatch(each -> each.status() == Progress.Status.DONE);
  }
}
