package dev.eventchain.pipeline.requirements;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.VerdictFile;
import dev.eventchain.project.AcceptedTexts;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The texts of an older state of requirements: themselves, or only their fingerprints. */
final class OlderTexts {

  private final Map<String, String> texts = new LinkedHashMap<>();
  private final Map<String, String> fingerprints = new LinkedHashMap<>();

  private OlderTexts() {}

  /**
   * Reads an older state.
   *
   * @param project the current project, whose settings say how to read its requirements
   * @param old a folder of a project, requirements in a file or folder, or a folder or file of
   *     results
   */
  static OlderTexts of(Project project, Path old) {
    OlderTexts older = new OlderTexts();
    Path inside = old.resolve(ProjectLayout.VERDICT);
    if (Files.isRegularFile(old.resolve(ProjectLayout.CONFIGURATION))) {
      older.add(new ProjectFolder(old).readRequirements().items());
    } else if (Files.isRegularFile(inside)) {
      older.addResults(inside);
    } else if (old.endsWith(ProjectLayout.VERDICT)) {
      older.addResults(old);
    } else if (!Files.exists(old)) {
      throw unreadable(FileRules.MISSING, "There is no such file or folder.", old);
    } else {
      older.add(project.requirementSources().readOlder(old).items());
    }
    return older;
  }

  private static DiagnosticException unreadable(Rule rule, String message, Path file) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, SourceLocation.of(file))
            .withHint(
                "Name an older folder of the project, a file or folder of requirements, or results"
                    + " with a verdict."));
  }

  private void add(List<WrittenRequirement> items) {
    for (WrittenRequirement item : items) {
      texts.put(item.id(), item.text());
      fingerprints.put(item.id(), AcceptedTexts.fingerprint(item.text()));
    }
  }

  private void addResults(Path verdict) {
    try {
      byte[] bytes = SourceText.read(verdict).text().getBytes(StandardCharsets.UTF_8);
      List<RequirementOutcome> outcomes =
          ResultJson.read(bytes, VerdictFile.class).requirements().orElse(List.of());
      if (outcomes.isEmpty()) {
        throw unreadable(FileRules.UNREADABLE, "These results know no requirements.", verdict);
      }
      outcomes.forEach(each -> fingerprints.put(each.id(), each.text()));
    } catch (IOException e) {
      throw unreadable(FileRules.UNREADABLE, "This is no verdict of a run.", verdict);
    }
  }

  Set<String> ids() {
    return fingerprints.keySet();
  }

  String fingerprint(String id) {
    return fingerprints.get(id);
  }

  /** Returns the text; empty if only its fingerprint is known. */
  Optional<String> text(String id) {
    return Optional.ofNullable(texts.get(id));
  }
}
