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
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.lsp4j.DocumentLink;

/**
 * Links of a text to the files of the workspace that it names: imports of constraints and
 * templates, and names of files in the YAML of a project. A name that no file of the workspace or
 * of the project has is no link.
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
    Optional<SourceText> text = workspace.text(file);
    if (text.isEmpty()) {
      return List.of();
    } else if (name.endsWith(".ocl")) {
      return in(file, text.get().text(), RULES, "");
    } else if (name.endsWith(".mtl")) {
      return in(file, text.get().text(), TEMPLATES, ".mtl");
    }
    return name.matches(".*\\.ya?ml") ? in(file, text.get().text(), YAML, "") : List.of();
  }

  private List<DocumentLink> in(Path file, String text, Pattern pattern, String ending) {
    Set<Path> files = Set.copyOf(workspace.files());
    TextLines lines = new TextLines(text);
    List<DocumentLink> links = new ArrayList<>();
    Matcher matcher = pattern.matcher(text);
    while (matcher.find()) {
      int group = matcher.groupCount() > 1 && matcher.group(1) == null ? 2 : 1;
      if (matcher.group(group) != null) {
        String named = matcher.group(group).replace("::", "/") + ending;
        target(file, named, !ending.isEmpty(), files)
            .ifPresent(
                target ->
                    links.add(
                        new DocumentLink(
                            edits.range(
                                file, lines.range(matcher.start(group), matcher.end(group))),
                            target.toUri().toString())));
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
