package dev.eventchain.architecture;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;

/** The Markdown of a folder, parsed as on GitHub, without the output of builds and runs. */
final class MarkdownFiles {

  /** The project's root folder. */
  static final Path ROOT = Path.of("..", "..");

  private static final Set<String> MADE = Set.of("target", "out");

  private static final Parser PARSER =
      Parser.builder().extensions(List.of(TablesExtension.create())).build();

  private MarkdownFiles() {}

  /** Returns each file of a folder and its subfolders, by relative path. */
  static SortedMap<Path, Node> in(Path root) throws IOException {
    List<Path> files = new ArrayList<>();
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            return folder.equals(root) || isWritten(folder.getFileName().toString())
                ? FileVisitResult.CONTINUE
                : FileVisitResult.SKIP_SUBTREE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            if (file.toString().endsWith(".md")) {
              files.add(file);
            }
            return FileVisitResult.CONTINUE;
          }
        });
    SortedMap<Path, Node> documents = new TreeMap<>();
    for (Path file : files) {
      documents.put(root.relativize(file), PARSER.parse(Files.readString(file)));
    }
    return documents;
  }

  private static boolean isWritten(String folder) {
    return folder.equals(".github") || !(folder.startsWith(".") || MADE.contains(folder));
  }
}
