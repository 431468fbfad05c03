package dev.eventchain.mcp.project;

import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.EnumSet;
import java.util.Set;

/**
 * The folder of the server, which nothing leads out of.
 *
 * @param root the folder, without symbolic links
 */
public record Boundary(Path root) {

  private static final String HINT =
      "Name a path below the folder of the server, relative to it, such as model/chain.xmi.";

  /**
   * Returns the boundary of a folder.
   *
   * @throws IOException if there is no such folder
   */
  public static Boundary of(Path folder) throws IOException {
    return new Boundary(folder.toRealPath());
  }

  /**
   * Returns a path that a client has named, relative to the folder; it need not exist.
   *
   * @throws DiagnosticException if it leads out of the folder, by itself or by a link
   */
  public Path inside(String name) {
    return inside(root, name);
  }

  /** As above, for a name relative to a folder inside. */
  public Path inside(Path folder, String name) {
    Path path;
    try {
      path = Path.of(name);
    } catch (InvalidPathException e) {
      throw outside(name, "is no path");
    }
    Path whole = folder.resolve(path).normalize();
    if (path.isAbsolute() || !whole.startsWith(root)) {
      throw outside(name, "leads out of the folder of the server");
    }
    requireInside(whole, name);
    return whole;
  }

  private void requireInside(Path path, String name) {
    Path existing = path;
    while (!Files.exists(existing, java.nio.file.LinkOption.NOFOLLOW_LINKS)) {
      existing = existing.getParent();
    }
    try {
      if (!existing.toRealPath().startsWith(root)) {
        throw outside(name, "is, by a symbolic link, outside the folder of the server");
      }
    } catch (IOException e) {
      throw outside(name, "is a symbolic link to what does not exist");
    }
  }

  private static DiagnosticException outside(String name, String how) {
    return McpRules.refusal(McpRules.OUTSIDE, "", "'" + name + "' " + how + ".", HINT);
  }

  /** Returns a path inside as a client names it: relative, with {@code .} for the folder itself. */
  public String nameOf(Path path) {
    String name = root.relativize(path).toString();
    return name.isEmpty() ? "." : name;
  }

  /**
   * Returns a path inside as an argument of a command: as a client names it, unless it would be
   * taken for an option or a file of arguments.
   */
  public String argument(Path path) {
    String name = nameOf(path);
    return name.startsWith("-") || name.startsWith("@") ? "./" + name : name;
  }

  /**
   * Returns a path that a client has named as an argument of a command.
   *
   * @throws DiagnosticException if it leads out of the folder, by itself or by a link below it
   */
  public String closed(String name) {
    Path path = inside(name);
    requireClosed(path);
    return argument(path);
  }

  /**
   * Fails if a symbolic link below a folder leads out of the server's folder: a command would
   * follow it.
   */
  public void requireClosed(Path folder) {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try {
      // There may be links behind links.
      Set<FileVisitOption> options = EnumSet.of(FileVisitOption.FOLLOW_LINKS);
      Files.walkFileTree(folder, options, Integer.MAX_VALUE, new Links());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Check of each symbolic link on a walk. */
  private final class Links extends SimpleFileVisitor<Path> {

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      return check(folder);
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      return check(file);
    }

    /** The command reports what it cannot read. */
    @Override
    public FileVisitResult visitFileFailed(Path file, IOException problem) {
      return check(file);
    }

    private FileVisitResult check(Path path) {
      if (Files.isSymbolicLink(path)) {
        requireInside(path, nameOf(path));
      }
      return FileVisitResult.CONTINUE;
    }
  }
}
