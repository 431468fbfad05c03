package dev.eventchain.pipeline.requirements;

import com.fasterxml.jackson.annotation.JsonInclude;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.AcceptedTexts;
import dev.eventchain.project.Requirements;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Changes in the requirements of a project since an older state, and the evidence that is about
 * older texts. Evidence that somebody has accepted for the current text is not stale.
 *
 * @param changes the changed requirements, the new ones and those that are gone
 * @param same the number of requirements with the same text
 * @param diagnostics the findings about the current sources, none of them an error
 */
public record RequirementChanges(List<Change> changes, int same, List<Diagnostic> diagnostics) {

  /** The kinds of changes; white space alone is none. */
  public enum Kind {
    CHANGED,
    NEW,
    GONE;

    private String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /**
   * A change of a requirement.
   *
   * @param kind {@code changed}, {@code new} or {@code gone}
   * @param source the file and line of the current text
   * @param before the older text, if it is known and there was one
   * @param now the current text, if there is one
   * @param stale what names the requirement and is about its older text
   */
  public record Change(
      String id,
      String kind,
      Optional<String> source,
      Optional<String> before,
      Optional<String> now,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<String> stale) {}

  /** Copies the lists. */
  public RequirementChanges {
    changes = List.copyOf(changes);
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Compares the current requirements with older ones.
   *
   * @param output the folder of the project's results, which may hold its chain
   * @param old an older folder of the project, its requirements in a file or folder, or results
   *     with a {@code verdict.json}
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if something cannot be read
   */
  public static RequirementChanges of(
      Project project, Path output, Path old, Suppressions suppressions) {
    OlderTexts older = OlderTexts.of(project, old);
    RunContext run = RequirementTable.reading(project, output, suppressions);
    Requirements requirements = run.requirements();
    RequirementUses uses = RequirementUses.of(run);
    List<Change> changes = new ArrayList<>();
    for (WrittenRequirement item : requirements.items()) {
      changed(project, item, older, uses).ifPresent(changes::add);
    }
    int same = requirements.items().size() - changes.size();
    Set<String> gone = new LinkedHashSet<>(older.ids());
    requirements.items().forEach(item -> gone.remove(item.id()));
    for (String id : gone) {
      changes.add(
          new Change(
              id,
              Kind.GONE.word(),
              Optional.empty(),
              older.text(id),
              Optional.empty(),
              uses.all(id)));
    }
    return new RequirementChanges(changes, same, requirements.diagnostics());
  }

  private static Optional<Change> changed(
      Project project, WrittenRequirement item, OlderTexts older, RequirementUses uses) {
    String text = AcceptedTexts.fingerprint(item.text());
    if (!older.ids().contains(item.id())) {
      return Optional.of(change(project, item, Kind.NEW, Optional.empty(), List.of()));
    } else if (older.fingerprint(item.id()).equals(text)) {
      return Optional.empty();
    }
    boolean accepted =
        project
            .accepted()
            .flatMap(all -> all.find(item.id()))
            .filter(entry -> entry.text().equals(text))
            .isPresent();
    List<String> stale = accepted ? List.of() : uses.all(item.id());
    return Optional.of(change(project, item, Kind.CHANGED, older.text(item.id()), stale));
  }

  private static Change change(
      Project project,
      WrittenRequirement item,
      Kind kind,
      Optional<String> before,
      List<String> stale) {
    return new Change(
        item.id(),
        kind.word(),
        Optional.of(project.placeOf(item.location())),
        before,
        Optional.of(item.text()),
        stale);
  }

  /** Returns whether there is evidence about older texts. */
  public boolean isAnyStale() {
    return changes.stream().anyMatch(each -> !each.stale().isEmpty());
  }

  /** Returns the changes for people. */
  public String text() {
    StringBuilder text = new StringBuilder();
    for (Change each : changes) {
      text.append("%-7s  %s".formatted(each.kind(), each.id()));
      each.source().ifPresent(source -> text.append("  ").append(source));
      text.append('\n');
      each.before().ifPresent(before -> text.append("  - ").append(before).append('\n'));
      each.now().ifPresent(now -> text.append("  + ").append(now).append('\n'));
      if (!each.stale().isEmpty()) {
        text.append("  stale: ").append(String.join(", ", each.stale())).append('\n');
      }
    }
    return text.append("unchanged: ").append(same).append('\n').toString();
  }

  /** Returns the changes as JSON. */
  public String json() {
    return JsonLayout.of(ResultJson.tree(new Json(changes, same))) + "\n";
  }

  private record Json(List<Change> changes, int unchanged) {}
}
