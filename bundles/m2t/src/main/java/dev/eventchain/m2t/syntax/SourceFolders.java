package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Modules in files: {@code a::b} is {@code a/b.mtl} below a source root. A root is a folder that
 * people named, the one that the importing module's own qualified name begins in, or one that the
 * importing file is in, at any depth. Otherwise it is {@code b.mtl} beside the importing file or
 * the main one, as is {@code b}.
 */
public final class SourceFolders implements ModuleSources {
  private final Path main;
  private final List<Path> roots;
  private final Map<String, Path> files = new HashMap<>();
  private final Map<Path, SourceText> texts = new HashMap<>();

  /**
   * Reads nothing yet.
   *
   * @param main the file of the main module
   * @param roots the source roots that people named
   */
  public SourceFolders(Path main, List<Path> roots) {
    this.main = main.normalize();
    this.roots = List.copyOf(roots);
  }

  /** The text of the main module. */
  public SourceText main() {
    return read(main);
  }

  /** The files that were read, in no order. */
  public Set<Path> files() {
    return Set.copyOf(texts.keySet());
  }

  @Override
  public Optional<SourceText> find(Syntax.Module importing, SourceText source, String name) {
    Path from = files.getOrDefault(source.name(), main);
    return (name.contains("::") ? qualified(importing, from, name) : plain(importing, from, name))
        .map(Path::normalize)
        .filter(Files::exists)
        .findFirst()
        .map(this::read);
  }

  /**
   * A qualified name never means the importing file, and the main one only if its path says so:
   * {@code shipped::main} in {@code main.mtl} is another module.
   */
  private Stream<Path> qualified(Syntax.Module importing, Path from, String name) {
    String nested = path(name);
    Set<Path> folders = new LinkedHashSet<>(roots);
    ownRoot(importing, from).ifPresent(folders::add);
    around(from, folders);
    around(main, folders);
    Stream<Path> below = folders.stream().map(folder -> folder.resolve(nested));
    Stream<Path> beside =
        plain(importing, from, name.substring(name.lastIndexOf(':') + 1))
            .filter(file -> !file.normalize().equals(main));
    return Stream.concat(below, beside).filter(file -> !file.normalize().equals(from));
  }

  private Stream<Path> plain(Syntax.Module importing, Path from, String name) {
    String file = path(name);
    Stream<Path> named =
        Stream.concat(roots.stream(), ownRoot(importing, from).stream())
            .map(folder -> folder.resolve(file));
    return Stream.concat(Stream.of(from, main).map(each -> each.resolveSibling(file)), named);
  }

  private static String path(String name) {
    return name.replace("::", "/") + ".mtl";
  }

  /** The folder of a file and all that it is in, under the names that people know them by. */
  private static void around(Path file, Set<Path> folders) {
    Path folder = file.resolveSibling("");
    int depth = file.toAbsolutePath().getNameCount();
    for (int up = 0; up < depth; up++) {
      folders.add(folder.normalize());
      folder = folder.resolve("..");
    }
  }

  /** Where the qualified name of a module begins, if that is the end of the name of its file. */
  private static Optional<Path> ownRoot(Syntax.Module module, Path file) {
    Path own = Path.of(path(module.name()));
    Path absolute = file.toAbsolutePath().normalize();
    return module.name().contains("::") && absolute.endsWith(own)
        ? Optional.of(file.resolveSibling("../".repeat(own.getNameCount() - 1)).normalize())
        : Optional.empty();
  }

  private SourceText read(Path file) {
    SourceText text = texts.computeIfAbsent(file, ModuleLoader::read);
    files.put(text.name(), file);
    return text;
  }
}
