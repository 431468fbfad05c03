package dev.eventchain.catalogue.vss;

import dev.eventchain.catalogue.signal.CatalogueFormat;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;

/**
 * The Vehicle Signal Specification, as {@code .vspec} files with what they include, or as VSS-tools
 * export it in JSON or YAML, with instances expanded or not.
 */
public final class VssFormat implements CatalogueFormat {

  /** Most parts of a path. */
  private static final int DEEPEST = 100;

  @Override
  public String prefix() {
    return "vss";
  }

  @Override
  public List<String> suffixes() {
    return List.of(".json", ".yaml", ".yml", ".vspec");
  }

  @Override
  public List<CatalogueSignal> read(CatalogueSource source, Consumer<Diagnostic> findings) {
    if (source.node().isPresent()) {
      findings.accept(CatalogueRules.noNode(source, "VSS"));
    }
    VssFiles files = new VssFiles(findings);
    files.read(source.file());
    source.overlays().forEach(files::overlay);
    VssNode root = new VssNode("", null);
    Set<String> structures = new TreeSet<>();
    files.entries().forEach((path, entry) -> add(root, structures, path, entry, findings));
    try {
      new VssInstances(findings).expand(root);
    } catch (VssInstances.TooManyException e) {
      String message = "Its instances give more than " + VssInstances.MOST + " nodes.";
      findings.accept(
          Diagnostic.of(CatalogueRules.SIZE, message, SourceLocation.of(source.file())));
      return List.of();
    }
    List<CatalogueSignal> signals = new ArrayList<>();
    root.children()
        .values()
        .forEach(child -> new VssLeaves(structures, findings).read(child, "", List.of(), signals));
    return signals;
  }

  private static void add(
      VssNode root,
      Set<String> structures,
      String path,
      VssFiles.Entry entry,
      Consumer<Diagnostic> findings) {
    Map<String, VssValue> attributes = entry.attributes();
    if (path.startsWith(VssFiles.STRUCTURES + ".")) {
      structures.add(path.substring(VssFiles.STRUCTURES.length() + 1));
      return;
    }
    String[] names = path.split("\\.", -1);
    if (names.length > DEEPEST) {
      String message = "The path has more than " + DEEPEST + " parts.";
      findings.accept(Diagnostic.of(CatalogueRules.SIZE, message, entry.last().key()));
      return;
    }
    VssNode node = root;
    for (String name : names) {
      node = node.children().computeIfAbsent(name, key -> new VssNode(key, entry.last()));
    }
    node.add(entry.last(), attributes);
  }
}
