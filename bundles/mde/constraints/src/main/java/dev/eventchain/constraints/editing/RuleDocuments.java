package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.DocumentImports;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Workspace;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The documents of a workspace, each read once for each version, and which of them import which. It
 * looks through all of them only after something has changed.
 */
final class RuleDocuments {

  private static final String EXTENSION = ".ocl";

  private final Workspace workspace;
  private final Map<Path, RuleText> texts = new HashMap<>();
  private final Map<Path, List<Path>> imports = new HashMap<>();
  private final Map<Path, Set<Path>> importers = new HashMap<>();

  /** The listed documents, with their places in the list. */
  private Map<Path, Integer> listed = Map.of();

  private List<Path> files = List.of();
  private Object state = new Object();

  RuleDocuments(Workspace workspace) {
    this.workspace = workspace;
  }

  static boolean isDocument(Path file) {
    return file.toString().endsWith(EXTENSION);
  }

  /** Returns the present text of a document. */
  Optional<RuleText> text(Path file) {
    update();
    return noted(file, workspace.text(file));
  }

  /** Returns the listed documents that a document imports, or that import it. */
  Set<Path> near(Path file) {
    update();
    Set<Path> near = new LinkedHashSet<>(imports.getOrDefault(file, List.of()));
    near.addAll(importers.getOrDefault(file, Set.of()));
    near.retainAll(listed.keySet());
    return near;
  }

  /** Returns whether a document is in the list of the workspace. */
  boolean isListed(Path file) {
    update();
    return listed.containsKey(file);
  }

  /** Returns the present texts of documents, in the order of the list, others last. */
  List<RuleText> inOrder(Collection<Path> some) {
    return some.stream()
        .sorted(Comparator.comparing(each -> listed.getOrDefault(each, Integer.MAX_VALUE)))
        .flatMap(each -> text(each).stream())
        .toList();
  }

  private void update() {
    Object now = workspace.state();
    if (now.equals(state)) {
      return;
    }
    list(workspace.files());
    listed.keySet().forEach(each -> noted(each, workspace.lastText(each)));
    state = now;
  }

  private void list(List<Path> present) {
    if (present == files) {
      return;
    }
    files = present;
    listed = new HashMap<>();
    present.stream()
        .filter(RuleDocuments::isDocument)
        .forEach(each -> listed.put(each, listed.size()));
    List.copyOf(texts.keySet()).stream()
        .filter(each -> !listed.containsKey(each))
        .forEach(this::forget);
  }

  private Optional<RuleText> noted(Path file, Optional<SourceText> source) {
    RuleText known = texts.get(file);
    if (source.isEmpty()) {
      forget(file);
      return Optional.empty();
    } else if (known != null && known.source() == source.get()) {
      return Optional.of(known);
    }
    forget(file);
    RuleText text = RuleText.of(file, source.get());
    texts.put(file, text);
    List<Path> imported = DocumentImports.named(text.document(), file);
    imports.put(file, imported);
    imported.forEach(
        each -> importers.computeIfAbsent(each, key -> new LinkedHashSet<>()).add(file));
    return Optional.of(text);
  }

  private void forget(Path file) {
    texts.remove(file);
    for (Path each : Optional.ofNullable(imports.remove(file)).orElse(new ArrayList<>())) {
      importers.computeIfPresent(
          each,
          (key, left) -> {
            left.remove(file);
            return left.isEmpty() ? null : left;
          });
    }
  }
}
