package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.Document;
import dev.eventchain.jsonmodels.InstanceObjects.Link;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;

/** Second step of the instance modeler: references by id. */
final class InstanceLinks {

  /** The longest id shown in messages; an id may be a whole object written as a text. */
  private static final int LONGEST = 60;

  private record Slot(EObject source, EReference reference) {}

  private final Document text;
  private final InstanceObjects objects;
  private final List<Diagnostic> findings;
  private final Map<Slot, List<EObject>> targets = new HashMap<>();

  InstanceLinks(Document text, InstanceObjects objects, List<Diagnostic> findings) {
    this.text = text;
    this.objects = objects;
    this.findings = findings;
  }

  void link() {
    Set<Link> broken = new HashSet<>();
    for (Link link : objects.links()) {
      if (!make(link)) {
        broken.add(link);
      }
    }
    for (Link link : objects.links()) {
      if (!broken.contains(link)) {
        requireKept(link);
      }
    }
    targets.forEach(InstanceLinks::arrange);
  }

  private boolean make(Link link) {
    EObject target = objects.byId().get(link.id());
    if (target == null) {
      String message = "There is no object '" + shortened(link.id()) + "'.";
      find(link, InstanceRules.REFERENCE_UNRESOLVED, message, hint(link));
      return false;
    }
    List<EObject> before =
        targets.computeIfAbsent(
            new Slot(link.source(), link.reference()), key -> new ArrayList<>());
    if (link.reference().isUnique() && before.contains(target)) {
      find(
          link,
          InstanceRules.REFERENCE_DUPLICATE,
          "'" + link.id() + "' is already in '" + link.reference().getName() + "'.",
          "");
      return false;
    }
    var problem = Assignment.of(link.source(), link.reference(), target).make();
    problem.ifPresent(found -> findings.add(found.withLocation(text.at(link.pointer()))));
    if (problem.isEmpty()) {
      before.add(target);
    }
    return problem.isEmpty();
  }

  private static String shortened(String id) {
    return id.length() > LONGEST ? id.substring(0, LONGEST) + "..." : id;
  }

  private String hint(Link link) {
    if (link.id().stripLeading().startsWith("{")) {
      return "Write an object as it is, not as a string.";
    }
    return link.id().startsWith("/") || link.id().contains("#")
        ? "Write the id of the target, not a path."
        : NearestName.hint(link.id(), objects.byId().keySet());
  }

  /** Reports a link that was undone by setting its opposite. */
  private void requireKept(Link link) {
    EObject target = objects.byId().get(link.id());
    Object value = link.source().eGet(link.reference());
    boolean kept = value instanceof List<?> list ? list.contains(target) : value == target;
    if (!kept) {
      find(
          link,
          InstanceRules.REFERENCE_CONTRADICTION,
          "'%s' is the opposite of '%s', whose value contradicts this."
              .formatted(link.reference().getName(), link.reference().getEOpposite().getName()),
          "Give only one of the two.");
    }
  }

  /** Restores the order of the text in a list that an opposite may have filled before. */
  private static void arrange(Slot slot, List<EObject> order) {
    if (slot.reference().isMany() && slot.reference().isUnique()) {
      EList<?> values = (EList<?>) slot.source().eGet(slot.reference());
      int position = 0;
      for (EObject target : order) {
        int current = values.indexOf(target);
        if (current > position) {
          values.move(position, current);
        }
        position += current >= 0 ? 1 : 0;
      }
    }
  }

  private void find(Link link, Rule rule, String message, String hint) {
    findings.add(Diagnostic.of(rule, message, text.at(link.pointer())).withHint(hint));
  }
}
