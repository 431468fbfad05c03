package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.project.HostedNode;
import dev.eventchain.project.SoftwareBase;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * Modules that nodes which are hosted as they are import, directly or through each other, from the
 * folders from which the nodes are imported themselves.
 */
public final class NodeModules {

  private NodeModules() {}

  /**
   * Finds the modules, without the files of the nodes.
   *
   * @param components components, of which those that are hosted as they are count
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  static SortedSet<Path> of(Collection<SoftwareBase.Component> components) {
    SortedSet<Path> all = new TreeSet<>();
    for (SoftwareBase.Component component : components) {
      component.node().ifPresent(node -> all.addAll(importedBy(component.file(), node)));
    }
    components.forEach(component -> all.remove(component.file()));
    return all;
  }

  /**
   * Finds the file of a node that is hosted as it is, and the modules that it imports.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  public static SortedSet<Path> withNode(SoftwareBase.Component component) {
    return importedBy(component.file(), component.node().orElseThrow());
  }

  private static SortedSet<Path> importedBy(Path file, HostedNode node) {
    SortedSet<Path> seen = new TreeSet<>();
    Deque<Path> pending = new ArrayDeque<>();
    pending.add(file);
    while (!pending.isEmpty()) {
      Path next = pending.remove();
      if (seen.add(next)) {
        addPackages(next, node.root(), pending);
        for (String module : PythonImports.candidates(SourceText.read(next).text())) {
          Path from = module.startsWith(".") ? above(next, module) : node.root();
          String name = module.replaceFirst("^\\.+", "").replace('.', '/');
          Path plain = from.resolve(name + ".py");
          Path packaged = from.resolve(name).resolve("__init__.py");
          if (Files.isRegularFile(plain)) {
            pending.add(plain);
          } else if (Files.isRegularFile(packaged)) {
            pending.add(packaged);
          }
        }
      }
    }
    return seen;
  }

  /** Adds what is run before a module: the files of the packages that it is in. */
  private static void addPackages(Path module, Path root, Deque<Path> pending) {
    Path folder = module.getParent();
    while (folder.startsWith(root) && !folder.equals(root)) {
      Path init = folder.resolve("__init__.py");
      if (Files.isRegularFile(init)) {
        pending.add(init);
      }
      folder = folder.getParent();
    }
  }

  /** Returns the folder that the dots of a relative import mean. */
  private static Path above(Path file, String module) {
    Path folder = file.getParent();
    for (int i = 1; i < module.length() && module.charAt(i) == '.' && folder != null; i++) {
      folder = folder.getParent();
    }
    return folder == null ? file.getRoot() : folder;
  }
}
