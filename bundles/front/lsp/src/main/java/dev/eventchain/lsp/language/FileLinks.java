package dev.eventchain.lsp.language;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.text.Edits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.lsp4j.DocumentLink;

/**
 * Links of a text to the files of the workspace that it names: imports of constraints and
 * templates, URIs of metamodels in them and in models, and names of files in the YAML of a project.
 * A name that no file of the workspace or of the project has is no link.
 */
public final class FileLinks {

  /** An import of Complete OCL: {@code import 'shop.ecore#/'}, with a name of its own or not. */
  private static final Pattern RULES =
      Pattern.compile(
          "^\\s*(?:import|include|library)\\b[^'\"\\n]*['\"]([^'\"#\\n]+)", Pattern.MULTILINE);

  /** An import, or what a module extends: {@code [import python::names /]}. */
  private static final Pattern TEMPLATES =
      Pattern.compile("\\[import\\s+([\\w:]+)|\\[module\\b[^\\]]*\\bextends\\s+([\\w:]+)");

  /** A name with an ending, outside of comments. */
  private static final Pattern YAML =
      Pattern.compile(
          "#.*|(?<![^\\s'\"\\[{,])([^\\s'\"\\[\\]{},#]+\\.[A-Za-z]+)(?![^\\s'\"\\]},])");

  /** The metamodels of a template: {@code [module m('http://x', 'http://y')]}. */
  private static final Pattern MODULE = Pattern.compile("\\[module\\b[^\\](]*\\(([^)]*)\\)");

  private static final Pattern QUOTED = Pattern.compile("['\"]([^'\"\\n]+)['\"]");

  /** A namespace of a model, or where its metamodels are: {@code "http://x x.ecore"}. */
  private static final Pattern NAMESPACE =
      Pattern.compile(
          "\\b(?:xmlns:[\\w.-]+|xsi:schemaLocation)\\s*=\\s*(?:\"([^\"<]*)\"|'([^'<]*)')");

  private static final Pattern WORD = Pattern.compile("[^\\s#]+");

  /** The URI that a metamodel, or a package in it, says that it has. */
  private static final Pattern URI = Pattern.compile("\\bnsURI\\s*=\\s*[\"']([^\"'<]+)[\"']");

  /** The most characters of a model in which namespaces are looked for. */
  private static final int HEAD = 1 << 16;

  private final Workspace workspace;
  private final Checks checks;
  private final Edits edits;

  /** Creates the links of a session. */
  public FileLinks(Workspace workspace, Checks checks, Edits edits) {
    this.workspace = workspace;
    this.checks = checks;
    this.edits = edits;
  }

  /** Returns the links of a text, in its order. */
  public List<DocumentLink> of(Path file) {
    String name = file.getFileName().toString();
    Optional<SourceText> source = workspace.text(file);
    if (source.isEmpty()) {
      return List.of();
    }
    String text = source.get().text();
    if (name.endsWith(".ocl")) {
      return in(file, text, RULES, "");
    } else if (name.endsWith(".mtl")) {
      List<DocumentLink> links = metamodels(file, text, MODULE, QUOTED);
      links.addAll(in(file, text, TEMPLATES, ".mtl"));
      return links;
    } else if (name.endsWith(".xmi") || name.endsWith(".eventchain")) {
      String head = text.substring(0, Math.min(HEAD, text.length()));
      return metamodels(file, head, NAMESPACE, WORD);
    }
    return name.matches(".*\\.ya?ml") ? in(file, text, YAML, "") : List.of();
  }

  /** Returns the links of the URIs, or names of files, in parts of a text. */
  private List<DocumentLink> metamodels(Path file, String text, Pattern parts, Pattern uris) {
    TextLines lines = new TextLines(text);
    Map<String, Path> known = declared(file);
    List<DocumentLink> links = new ArrayList<>();
    Matcher part = parts.matcher(text);
    while (part.find()) {
      int group = part.group(1) == null ? 2 : 1;
      Matcher uri = uris.matcher(text).region(part.start(group), part.end(group));
      while (uri.find()) {
        int named = uri.groupCount();
        metamodel(file, uri.group(named), known)
            .ifPresent(
                target -> links.add(link(file, lines, uri.start(named), uri.end(named), target)));
      }
    }
    return links;
  }

  private Optional<Path> metamodel(Path file, String named, Map<String, Path> known) {
    return Optional.ofNullable(known.get(named.replace("&amp;", "&")))
        .or(
            () ->
                named.endsWith(".ecore")
                    ? target(file, named, false, Set.copyOf(workspace.files()))
                    : Optional.empty());
  }

  /** Returns the metamodels that a text may name, by their URIs; the nearest one of each. */
  private Map<String, Path> declared(Path file) {
    Map<String, Path> declared = new HashMap<>();
    for (Path ecore : checks.metamodels(file)) {
      Matcher uri = URI.matcher(workspace.text(ecore).map(SourceText::text).orElse(""));
      while (uri.find()) {
        declared.putIfAbsent(uri.group(1).replace("&amp;", "&"), ecore);
      }
    }
    return declared;
  }

  private DocumentLink link(Path file, TextLines lines, int start, int end, Path target) {
    return new DocumentLink(edits.range(file, lines.range(start, end)), target.toUri().toString());
  }

  private List<DocumentLink> in(Path file, String text, Pattern pattern, String ending) {
    Set<Path> files = Set.copyOf(workspace.files());
    TextLines lines = new TextLines(text);
    List<DocumentLink> links = new ArrayList<>();
    Map<String, Path> known = pattern == RULES ? declared(file) : Map.of();
    Matcher matcher = pattern.matcher(text);
    while (matcher.find()) {
      int group = matcher.groupCount() > 1 && matcher.group(1) == null ? 2 : 1;
      if (matcher.group(group) != null) {
        String named = matcher.group(group).replace("::", "/") + ending;
        Optional.ofNullable(known.get(matcher.group(group)))
            .or(() -> target(file, named, !ending.isEmpty(), files))
            .ifPresent(
                target ->
                    links.add(link(file, lines, matcher.start(group), matcher.end(group), target)));
      }
    }
    return links;
  }

  /**
   * Returns the file of a name.
   *
   * @param isModule true for that of a module, which is relative to the folder of the text or to
   *     one above it
   */
  private Optional<Path> target(Path file, String named, boolean isModule, Set<Path> files) {
    try {
      Path relative = Path.of(named);
      for (Path folder = file.getParent(); folder != null; folder = folder.getParent()) {
        Path target = folder.resolve(relative).normalize();
        if (!target.equals(file) && (files.contains(target) || isInProject(target))) {
          return Optional.of(target);
        }
        if (!isModule) {
          return Optional.empty();
        }
      }
    } catch (InvalidPathException e) {
      // No path on this system, so it names no file.
    }
    return Optional.empty();
  }

  /** Returns whether a path is a file of a project of the workspace, also behind links. */
  private boolean isInProject(Path target) {
    try {
      Path real = target.toRealPath();
      for (Path project : checks.files().projects()) {
        if (Files.isRegularFile(real) && real.startsWith(project.toRealPath())) {
          return true;
        }
      }
    } catch (IOException e) {
      // There is no such file.
    }
    return false;
  }
}
