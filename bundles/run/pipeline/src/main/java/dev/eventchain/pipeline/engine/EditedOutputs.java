package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageRecord;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** Outputs of an up-to-date stage, which people may have edited. */
final class EditedOutputs {

  private EditedOutputs() {}

  /**
   * Reports the outputs that a person edited, and has the stage check them.
   *
   * @return the recorded result; if the stage checked edited outputs, with the findings in them
   *     instead of those in its own versions
   * @throws DiagnosticException if they cannot be read
   */
  static StageResult check(RunContext run, StageWork work, StageRecord record) {
    List<String> outputs = List.copyOf(record.outputs().keySet());
    List<String> edited = outputs.stream().filter(run.output()::isEdited).toList();
    Optional<StageWork.Checked> checked =
        edited.isEmpty() ? Optional.empty() : work.checkEdited(run, edited);
    Set<Diagnostic> found = new LinkedHashSet<>(record.diagnostics());
    checked.ifPresent(
        now -> {
          Set<String> files = files(run, edited);
          found.removeIf(each -> files.contains(each.location().file()));
          found.addAll(now.diagnostics());
        });
    edited.forEach(name -> run.output().accept(name).ifPresent(found::add));
    return new StageResult(
        checked.map(StageWork.Checked::details).orElse(record.details()),
        outputs,
        List.copyOf(found),
        record.report(),
        record.coverage());
  }

  private static Set<String> files(RunContext run, List<String> names) {
    return names.stream()
        .map(name -> SourceLocation.of(run.file(name)).file())
        .collect(Collectors.toSet());
  }
}
