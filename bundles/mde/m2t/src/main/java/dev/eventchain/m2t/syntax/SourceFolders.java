package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Modules in files: {@code a::b} is {@code a/b.mtl} below a source root. A root is a folder named
 * by the user, the root of the importing module's own qualified name, or a folder with a subfolder
 * {@code a} around the importing file. Otherwise {@code a::b} is {@code a/b.mtl} or {@code b.mtl}
 * next to the importing file or the main one, as is {@code b}; or {@code a/b.mtl} next to the
 * folder of the file.
 */
public final class SourceFolders implements ModuleSources {
  /**
   * Files by which Eclipse, Maven and this program know a project. Folders around it do not affect
   * the resolution. The names are written out, since the engine depends on none of these programs.
   */
  private static final List<String> PROJECT_FILES =
      List.of(".project", "META-INF", "pom.xml", "eventchain.yaml");

  /** Number of folders searched outside projects: the folder of a file and its parent. */
  private static final int NEAR = 2;

  private final Path main;
  private final List<Path> roots;
  private final Function<Path, Optional<SourceText>> reader;

  /** Files by the names of their texts. */
  private final Map<String, Path> files = new HashMap<>();

  /** Texts by absolute paths: a file that is reached in several ways is one module. */
  private final Map<Path, SourceText> texts = new HashMap<>();

  /**
   * Creates a resolver without reading files.
   *
   * @param main the file of the main module
   * @param roots the source roots named by the user
   */
  public SourceFolders(Path main, List<Path> roots) {
    this(
        main,
        roots,
        file -> Files.exists(file) ? Optional.of(ModuleLoader.read(file)) : Optional.empty());
  }

  /**
   * Creates a resolver of files that may be open in editors.
   *
   * @param reader returns the text of a file; empty if there is none
   */
  public SourceFolders(Path main, List<Path> roots, Function<Path, Optional<SourceText>> reader) {
    this.main = main.normalize();
    this.roots = List.copyOf(roots);
    this.reader = reader;
  }

  /** Returns the text of the main module. */
  public SourceText main() {
    return read(main).orElseGet(() -> ModuleLoader.read(main)); // which says what is wrong
  }

  /** Returns the files that were read, in no order. */
  public Set<Path> files() {
    return Set.copyOf(files.values());
  }

  /** Returns the file of a text that was read, by the text's name. */
  public Optional<Path> file(String name) {
    return Optional.ofNullable(files.get(name));
  }

  @Override
  public Optional<SourceText> find(Syntax.Module importing, SourceText source, String name) {
    Path from = fileOf(source);
    return first(
        name.contains("::") ? qualified(importing, from, name) : plain(importing, from, name));
  }

  /**
   * Finds {@code a::b} in the other folders around the importing file or the main one, up to their
   * project or a source root. This is the last resort, because the user did not name these folders.
   */
  public Optional<SourceText> findAbove(Syntax.Module importing, SourceText source, String name) {
    Path from = fileOf(source);
    Stream<Path> folders =
        Stream.of(from, main)
            .filter(file -> name.contains("::"))
            .flatMap(file -> reach(importing, file).stream());
    return first(below(folders, name).filter(file -> !file.normalize().equals(from)));
  }

  private Path fileOf(SourceText source) {
    return files.getOrDefault(source.name(), main);
  }

  private Optional<SourceText> first(Stream<Path> candidates) {
    return candidates.map(Path::normalize).flatMap(file -> read(file).stream()).findFirst();
  }

  /**
   * Returns candidates for a qualified name. It never refers to the importing file, and to the main
   * file only if the path matches: {@code shipped::main} in {@code main.mtl} is another module.
   */
  private Stream<Path> qualified(Syntax.Module importing, Path from, String name) {
    Set<Path> folders = new LinkedHashSet<>(roots);
    ownRoot(importing, from).ifPresent(folders::add);
    Stream.of(from, main).flatMap(file -> ownOrRoot(file, name)).forEach(folders::add);
    Stream<Path> beside =
        plain(importing, from, name.substring(name.lastIndexOf(':') + 1))
            .filter(file -> !file.normalize().equals(main));
    Stream<Path> besideFolder =
        Stream.of(from, main).flatMap(file -> reach(importing, file).stream().limit(NEAR));
    return Stream.of(below(folders.stream(), name), beside, below(besideFolder, name))
        .flatMap(each -> each)
        .filter(file -> !file.normalize().equals(from));
  }

  private static Stream<Path> below(Stream<Path> folders, String name) {
    return folders.map(folder -> folder.resolve(path(name)));
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

  /** Returns the folder of a file, and the source roots implied by the first segment of a name. */
  private static Stream<Path> ownOrRoot(Path file, String name) {
    String first = name.substring(0, name.indexOf("::"));
    List<Path> all = around(file);
    List<Path> inside = upTo(all, SourceFolders::isProject).orElse(all);
    return IntStream.range(0, inside.size())
        .filter(up -> up == 0 || inside.get(up - 1).toAbsolutePath().normalize().endsWith(first))
        .mapToObj(inside::get);
  }

  /** Returns the folders around a file that are searched without being named. */
  private List<Path> reach(Syntax.Module importing, Path file) {
    List<Path> all = around(file);
    return upTo(all, folder -> isProject(folder) || isNamed(folder))
        .or(() -> ownRoot(importing, file).flatMap(root -> upTo(all, root::equals)))
        .orElse(all.subList(0, Math.min(NEAR, all.size())));
  }

  private static Optional<List<Path>> upTo(List<Path> folders, Predicate<Path> last) {
    return IntStream.range(0, folders.size())
        .filter(up -> last.test(folders.get(up)))
        .mapToObj(up -> folders.subList(0, up + 1))
        .findFirst();
  }

  private static boolean isProject(Path folder) {
    return PROJECT_FILES.stream().anyMatch(file -> Files.exists(folder.resolve(file)));
  }

  private boolean isNamed(Path folder) {
    Path absolute = folder.toAbsolutePath().normalize();
    return roots.stream().anyMatch(root -> root.toAbsolutePath().normalize().equals(absolute));
  }

  /** Returns the folder of a file and its parents, under their displayed names. */
  private static List<Path> around(Path file) {
    List<Path> folders = new ArrayList<>();
    Path folder = file.resolveSibling("");
    int depth = file.toAbsolutePath().normalize().getNameCount();
    for (int up = 0; up < depth; up++) {
      folders.add(folder.normalize());
      folder = folder.resolve("..");
    }
    return folders;
  }

  /**
   * Returns the root of the qualified name of a module, if the path of its file ends with that
   * name.
   */
  private static Optional<Path> ownRoot(Syntax.Module module, Path file) {
    Path own = Path.of(path(module.name()));
    Path absolute = file.toAbsolutePath().normalize();
    return module.name().contains("::") && absolute.endsWith(own)
        ? Optional.of(file.resolveSibling("../".repeat(own.getNameCount() - 1)).normalize())
        : Optional.empty();
  }

  private Optional<SourceText> read(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    SourceText known = texts.get(absolute);
    if (known != null) {
      return Optional.of(known);
    }
    Optional<SourceText> text = reader.apply(file);
    text.ifPresent(
        found -> {
          texts.put(absolute, found);
          files.put(found.name(), file);
        });
    return text;
  }
}
