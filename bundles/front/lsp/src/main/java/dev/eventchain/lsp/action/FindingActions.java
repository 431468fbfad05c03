package dev.eventchain.lsp.action;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.TextFix;
import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.text.Edits;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.WorkspaceEdit;

/**
 * Code actions for findings: the replacement that a hint names, a suppression, and the page of the
 * rule.
 */
public final class FindingActions {

  /** The command that shows the page of a rule, with its id as argument. */
  public static final String EXPLAIN = "eventchain.explain";

  private static final String UNRESOLVED = "xmi.reference.unresolved";

  private final Workspace files;
  private final Findings findings;
  private final Edits edits;

  /** Creates the actions of a session. */
  public FindingActions(Workspace files, Findings findings, Edits edits) {
    this.files = files;
    this.findings = findings;
    this.edits = edits;
  }

  /**
   * Returns what can be done about the findings in a range of a file.
   *
   * @param today the day from which a suppression counts
   */
  public List<CodeAction> of(Path file, Range range, LocalDate today) {
    List<CodeAction> actions = new ArrayList<>();
    for (Findings.Shown shown : findings.in(file, range)) {
      Diagnostic finding = shown.finding();
      fixes(file, finding)
          .forEach(
              fix -> {
                CodeAction action = action(fix.title(), CodeActionKind.QuickFix, shown);
                action.setEdit(edits.of(List.of(fix.edit())));
                action.setIsPreferred(fix.certain());
                actions.add(action);
              });
      suppression(shown, today)
          .ifPresent(
              edit -> {
                String title = "Suppress this " + finding.id() + " for 30 days, with a reason";
                CodeAction action = action(title, CodeActionKind.QuickFix, shown);
                action.setEdit(edit);
                actions.add(action);
              });
      String title = "Explain " + finding.id();
      CodeAction explain = action(title, CodeActionKind.QuickFix, shown);
      explain.setCommand(new Command(title, EXPLAIN, List.of(finding.id())));
      actions.add(explain);
    }
    return actions;
  }

  private static CodeAction action(String title, String kind, Findings.Shown shown) {
    CodeAction action = new CodeAction(title);
    action.setKind(kind);
    action.setDiagnostics(List.of(shown.asSent()));
    return action;
  }

  private List<Fix> fixes(Path file, Diagnostic finding) {
    Optional<SourceText> text = files.text(file);
    if (text.isEmpty() || finding.location().line() < 1) {
      return List.of();
    }
    List<Fix> fixes = new ArrayList<>();
    String content = text.get().text();
    int offset =
        text.get().offset(finding.location().line(), Math.max(1, finding.location().column()));
    TextFix.nearestName(content, offset, extension(file), finding.message(), finding.hint())
        .ifPresent(fix -> fixes.add(fix("Change to '" + fix.by() + "'", file, content, fix)));
    if (finding.id().equals(UNRESOLVED)) {
      TextFix.withoutReference(content, offset, finding.message())
          .ifPresent(fix -> fixes.add(fix("Remove the reference", file, content, fix)));
    }
    fixes.addAll(new ModelChanges(files).of(file, finding));
    return fixes;
  }

  private static Fix fix(String title, Path file, String text, TextFix fix) {
    return new Fix(
        title,
        new FileEdit(file, new TextLines(text).range(fix.start(), fix.end()), fix.by()),
        true);
  }

  private static String extension(Path file) {
    String name = file.getFileName().toString();
    return name.substring(name.lastIndexOf('.') + 1);
  }

  private Optional<WorkspaceEdit> suppression(Findings.Shown shown, LocalDate today) {
    return shown
        .project()
        .map(ProjectFolder::new)
        .flatMap(project -> Suppression.of(shown.finding(), project, today))
        .map(
            entry ->
                edits.appended(
                    entry.file(), files.text(entry.file()).map(SourceText::text), entry.text()));
  }
}
