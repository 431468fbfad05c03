package dev.eventchain.pipeline.project;

import dev.eventchain.check.CheckRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.files.SourceFile;
import dev.eventchain.project.AcceptedTexts;
import java.time.LocalDate;
import java.util.List;

/** Records that people have looked at the evidence for the texts of requirements. */
public final class Acceptance {

  private Acceptance() {}

  /**
   * Records the current texts of requirements as accepted.
   *
   * @param ids the requirements; all of them if there are none
   * @param by who accepts them
   * @return the requirements that are accepted now
   * @throws DiagnosticException INPUT if a requirement is unknown, or a file cannot be read or
   *     written
   */
  public static AcceptedTexts record(Project project, List<String> ids, String by, LocalDate on) {
    List<WrittenRequirement> written = project.readRequirements().items();
    List<String> known = written.stream().map(WrittenRequirement::id).toList();
    List<Diagnostic> unknown =
        ids.stream()
            .filter(id -> !known.contains(id))
            .map(id -> unknown(project, id, known))
            .toList();
    if (!unknown.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, unknown);
    }
    AcceptedTexts accepted =
        project
            .accepted()
            .orElseGet(() -> new AcceptedTexts(List.of()))
            .accepting(written, ids.isEmpty() ? known : ids, by, on);
    SourceFile.write(project.acceptedFile(), accepted.toYaml());
    return accepted;
  }

  private static Diagnostic unknown(Project project, String id, List<String> known) {
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_UNKNOWN,
            "'" + id + "' is not a requirement of this project.",
            SourceLocation.of(project.firstRequirements()))
        .withHint(NearestName.hint(id, known));
  }
}
