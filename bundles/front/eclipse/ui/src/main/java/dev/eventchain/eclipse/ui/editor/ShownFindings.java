package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.diagnostics.Severity;
import dev.eventchain.eclipse.ui.editor.model.TreeContent;
import dev.eventchain.eclipse.ui.editor.model.TreeLabels;
import dev.eventchain.eclipse.ui.editor.validation.ElementFinding;
import dev.eventchain.model.eventchain.EventChain;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The findings about a chain, by its elements. */
final class ShownFindings implements TreeLabels.Findings {

  private List<ElementFinding> all = List.of();
  private final Map<Object, Severity> worst = new HashMap<>();

  /** Replaces the findings by those of a new check. */
  void set(EventChain chain, List<ElementFinding> findings) {
    all = List.copyOf(findings);
    worst.clear();
    fill(chain);
  }

  private Severity fill(Object element) {
    Severity most =
        about(element).stream().map(ElementFinding::severity).min(Severity::compareTo).orElse(null);
    for (Object child : TreeContent.children(element)) {
      most = worse(most, fill(child));
    }
    if (most != null) {
      worst.put(element, most);
    }
    return most;
  }

  private static Severity worse(Severity first, Severity second) {
    if (first == null || second == null) {
      return first == null ? second : first;
    }
    return first.compareTo(second) <= 0 ? first : second;
  }

  List<ElementFinding> all() {
    return all;
  }

  /** Returns the findings about an element itself. */
  List<ElementFinding> about(Object element) {
    return all.stream().filter(finding -> finding.element() == element).toList();
  }

  @Override
  public Severity worst(Object element) {
    return worst.get(element);
  }

  @Override
  public String text(Object element) {
    String text =
        about(element).stream().map(ElementFinding::text).collect(Collectors.joining("\n"));
    return text.isEmpty() ? null : text;
  }
}
