package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.XmlElement;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/** The elements of one or more files by their paths, and the references between them. */
final class ArxmlTree {

  /** Kinds of elements that references name instead of the kind that an element has. */
  private static final Set<String> GENERAL =
      Set.of("FRAME", "PDU", "I-PDU", "FIBEX-ELEMENT", "IDENTIFIABLE", "REFERRABLE", "AR-ELEMENT");

  private static final String PACKAGE = "AR-PACKAGE";

  /** Unknown paths with hints: to find the nearest of ten thousand signals takes a while. */
  private static final int HINTS = 10;

  private final Consumer<Diagnostic> findings;
  private final Map<String, ArxmlElement> byPath = new LinkedHashMap<>();

  /** Paths from which relative references go on, by the package and their labels; "" for all. */
  private final Map<String, Map<String, String>> bases = new HashMap<>();

  /** Elements that are not read, since another variant has their path. */
  private final List<ArxmlElement> otherVariants = new ArrayList<>();

  private final Set<XmlElement> reported = Collections.newSetFromMap(new IdentityHashMap<>());
  private int hints;

  ArxmlTree(Consumer<Diagnostic> findings) {
    this.findings = findings;
  }

  /** Adds the elements of a file; packages go on from file to file. */
  void add(XmlElement root) {
    add(new ArxmlElement(root, ""), "");
  }

  private void add(ArxmlElement element, String parent) {
    if (element.tag().equals("REFERENCE-BASE")) {
      base(element);
    }
    if (!element.path().equals(parent) && !isNew(element)) {
      return;
    }
    element
        .xml()
        .children()
        .forEach(child -> add(ArxmlElement.in(element.path(), child), element.path()));
  }

  /** Returns whether no element has its path, or both are the same package. */
  private boolean isNew(ArxmlElement element) {
    ArxmlElement other = byPath.putIfAbsent(element.path(), element);
    boolean isPackage = element.tag().equals(PACKAGE);
    if (other == null || (isPackage && other.tag().equals(PACKAGE))) {
      return true;
    }
    if (element.isVariant() && other.isVariant()) {
      otherVariants.add(element);
      return false;
    }
    boolean sameFile = element.location().file().equals(other.location().file());
    if (sameFile || !areAlike(element.xml(), other.xml())) {
      findings.accept(
          Diagnostic.of(
                  CatalogueRules.ENTRY,
                  "There is another element '" + element.path() + "'.",
                  element.location())
              .withHint(
                  sameFile
                      ? "It is not read; give one of them another SHORT-NAME."
                      : "It is not read: only packages may go on in another file. Merge the files."));
    }
    return false;
  }

  private static boolean areAlike(XmlElement one, XmlElement other) {
    boolean alike =
        one.name().equals(other.name())
            && one.text().equals(other.text())
            && one.children().size() == other.children().size();
    for (int i = 0; alike && i < one.children().size(); i++) {
      alike = areAlike(one.children().get(i), other.children().get(i));
    }
    return alike;
  }

  private void base(ArxmlElement base) {
    Map<String, String> ofPackage = bases.computeIfAbsent(base.path(), key -> new HashMap<>());
    String path = base.text("PACKAGE-REF").orElse("");
    base.text("SHORT-LABEL").ifPresent(label -> ofPackage.putIfAbsent(label, path));
    if (base.text("IS-DEFAULT").filter("true"::equals).isPresent()) {
      ofPackage.putIfAbsent("", path);
    }
  }

  /** Returns elements that are not read, since another variant has their path. */
  List<ArxmlElement> otherVariants() {
    return otherVariants;
  }

  /** Returns all elements with a tag, in the order of the files. */
  List<ArxmlElement> all(String tag) {
    return byPath.values().stream().filter(it -> it.tag().equals(tag)).toList();
  }

  /** Returns the nearest element with a tag that an element is in. */
  Optional<ArxmlElement> around(ArxmlElement inner, String tag) {
    for (String path = inner.path(); !path.isEmpty(); path = above(path)) {
      ArxmlElement each = byPath.get(path);
      if (each != null && each.tag().equals(tag)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  private static String above(String path) {
    return path.substring(0, Math.max(0, path.lastIndexOf('/')));
  }

  /** Returns the element to which the first reference leads that is reached by tags. */
  Optional<ArxmlElement> follow(ArxmlElement from, Set<String> kinds, String... tags) {
    return from.first(tags).flatMap(reference -> follow(reference, kinds));
  }

  /**
   * Returns the element to which a reference leads. That it leads nowhere, or to another kind of
   * element, is a finding.
   *
   * @param kinds the tags that the element may have; empty for all
   */
  Optional<ArxmlElement> follow(ArxmlElement reference, Set<String> kinds) {
    String path = absolute(reference);
    ArxmlElement target = byPath.get(path);
    String wanted = reference.attribute("DEST");
    if (target == null) {
      report(reference, "There is no element '" + path + "'.", path);
      return Optional.empty();
    }
    boolean other = !wanted.isEmpty() && !wanted.equals(target.tag()) && !GENERAL.contains(wanted);
    if (other || (!kinds.isEmpty() && !kinds.contains(target.tag()))) {
      String kind = other ? wanted : String.join(" or ", kinds.stream().sorted().toList());
      report(reference, "'%s' is of the kind %s, not %s.".formatted(path, target.tag(), kind), "");
      return Optional.empty();
    }
    return Optional.of(target);
  }

  /** Returns the path of a reference, which may be relative to a base of a package around it. */
  private String absolute(ArxmlElement reference) {
    String written = reference.text();
    if (written.startsWith("/")) {
      return written;
    }
    for (String at = reference.path(); !at.isEmpty(); at = above(at)) {
      String base = bases.getOrDefault(at, Map.of()).get(reference.attribute("BASE"));
      if (base != null) {
        return base + "/" + written;
      }
    }
    return written;
  }

  private void report(ArxmlElement reference, String message, String unknown) {
    if (!reported.add(reference.xml())) {
      return;
    }
    Diagnostic finding = Diagnostic.of(CatalogueRules.REFERENCE, message, reference.location());
    boolean hinted = !unknown.isEmpty() && ++hints <= HINTS;
    findings.accept(
        hinted
            ? finding.withHint(
                NearestName.of(unknown, near(unknown))
                    .map(near -> "Did you mean `" + near + "`?")
                    .orElse("Name the file that has it under `overlays`."))
            : finding);
  }

  /** Returns the paths of elements that are in the same one as a path, or have its last name. */
  private List<String> near(String unknown) {
    String end = unknown.substring(above(unknown).length());
    return byPath.keySet().stream()
        .filter(path -> path.endsWith(end) || above(path).equals(above(unknown)))
        .toList();
  }
}
