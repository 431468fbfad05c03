package dev.eventchain.pipeline.engine;

import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.StageOutcome;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** The stages whose results a stage needs, for runs in which a failure does not end the others. */
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

  /** Returns whether all stages that a stage needs succeeded in this run. */
  static boolean areDone(Stage stage, Map<Stage, StageOutcome> outcomes) {
    return NEEDED.getOrDefault(stage, List.of()).stream()
        .map(outcomes::get)
        .allMatch(each -> each.status() == Progress.Status.DONE);
  }
}
