package dev.eventchain.editing;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlEvents;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EObject;

/** Finds where the elements of metamodels are declared in their {@code .ecore} files. */
public final class EcorePlaces {

  private static final int DEEPEST = 100;

  private final Workspace workspace;

  /** Files of a list as the workspace names them, by their absolute paths. */
  private record Named(List<Path> files, Map<Path, Path> byAbsolute) {}

  private volatile Named named = new Named(List.of(), Map.of());

  /** The places of names by qualified name, for each text. */
  private final Map<SourceText, Map<String, TextRange>> known =
      Collections.synchronizedMap(new WeakHashMap<>());

  /** Finds places in the files of a workspace. */
  public EcorePlaces(Workspace workspace) {
    this.workspace = workspace;
  }

  /** Returns where an element has its name; empty for one that is not read from a text. */
  public Optional<FileRange> of(EObject element) {
    URI uri = element.eResource() == null ? null : element.eResource().getURI();
    if (uri == null || !uri.isFile() || !(element instanceof ENamedElement)) {
      return Optional.empty();
    }
    Path file = inWorkspace(Path.of(uri.toFileString()));
    return workspace
        .text(file)
        .map(text -> known.computeIfAbsent(text, EcorePlaces::namesIn).get(qualified(element)))
        .map(range -> new FileRange(file, range));
  }

  /** Returns the file as the workspace names it. */
  private Path inWorkspace(Path file) {
    List<Path> files = workspace.files();
    Named present = named;
    if (present.files() != files) {
      Map<Path, Path> byAbsolute = new HashMap<>();
      files.forEach(each -> byAbsolute.putIfAbsent(each.toAbsolutePath().normalize(), each));
      present = new Named(files, byAbsolute);
      named = present;
    }
    return present.byAbsolute().getOrDefault(file.toAbsolutePath().normalize(), file);
  }

  private static String qualified(EObject element) {
    String name = element instanceof ENamedElement named ? String.valueOf(named.getName()) : "";
    return element.eContainer() == null ? name : qualified(element.eContainer()) + "/" + name;
  }

  /** Returns the names up to the first fault of the text. */
  private static Map<String, TextRange> namesIn(SourceText source) {
    Map<String, TextRange> names = new HashMap<>();
    Names handler = new Names(source, names);
    try {
      XmlEvents.read(source, DEEPEST, handler);
    } catch (XmlEvents.MalformedException e) {
      return names; // A metamodel that is being edited; its findings are reported elsewhere.
    }
    return names;
  }

  private static final class Names implements XmlEvents.Handler {
    private final SourceText source;
    private final TextLines lines;
    private final Map<String, TextRange> names;
    private final Deque<String> around = new ArrayDeque<>();

    private Names(SourceText source, Map<String, TextRange> names) {
      this.source = source;
      this.lines = new TextLines(source.text());
      this.names = names;
    }

    @Override
    public void start(String element, String[] attributes, int offset) {
      String outer = around.isEmpty() ? "" : around.peek();
      for (int i = 0; i < attributes.length; i += 2) {
        if (attributes[i].equals("name")) {
          String qualified = (outer.isEmpty() ? "" : outer + "/") + attributes[i + 1];
          int quote = XmlEvents.attribute(source, offset, "name") + "name".length();
          String text = source.text();
          while (quote < text.length() && "\"'".indexOf(text.charAt(quote)) < 0) {
            quote++;
          }
          int end = Math.min(text.length(), quote + 1 + attributes[i + 1].length());
          names.putIfAbsent(qualified, lines.range(quote + 1, end));
          outer = qualified;
        }
      }
      around.push(outer);
    }

    @Override
    public void text(char[] characters, int from, int length) {}

    @Override
    public void end() {
      around.pop();
    }
  }
}
