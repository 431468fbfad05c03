package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.List;

/**
 * Open questions about a software base that was described from existing sources: what these do not
 * say. A question with an answer is not open.
 */
public final class OpenQuestions {

  private static final NumberRange LINES = NumberRange.of(1, Integer.MAX_VALUE);

  private OpenQuestions() {}

  /**
   * Returns a warning for each open question of a project; none without such a file.
   *
   * @throws DiagnosticException INPUT if the file cannot be read or is malformed ({@code
   *     project.questions})
   */
  public static List<Diagnostic> read(ProjectFolder folder) {
    if (ProjectFolder.isAbsent(folder.questionsFile())) {
      return List.of();
    }
    List<Diagnostic> problems = new ArrayList<>();
    DocumentRules rules = DocumentRules.all(ProjectRules.PROJECT_QUESTIONS);
    SourceText text = SourceText.read(folder.questionsFile());
    List<Diagnostic> open = new ArrayList<>();
    Document.parse(text, DocumentFormat.JSON, rules, problems::add)
        .objects(problems::add)
        .forEach(entry -> add(entry, open));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return open;
  }

  private static void add(ObjectReader entry, List<Diagnostic> open) {
    String question = entry.requiredText("question");
    String file = entry.text("file").orElse("");
    String line = entry.has("line") ? ":" + entry.requiredWholeNumber("line", LINES) : "";
    boolean answered = entry.text("answer").filter(answer -> !answer.isBlank()).isPresent();
    entry.refuseOthers();
    if (!answered) {
      open.add(
          Diagnostic.of(
                  ProjectRules.PROJECT_QUESTION,
                  file.isEmpty() ? question : file + line + ": " + question,
                  entry.location())
              .withHint(
                  "Correct the descriptions where they differ, and write an \"answer\" beside it."));
    }
  }
}
