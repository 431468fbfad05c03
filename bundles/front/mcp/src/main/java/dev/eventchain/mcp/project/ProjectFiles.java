package dev.eventchain.mcp.project;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** The files that a client may read. */
public final class ProjectFiles {

  /** Largest file that is sent, in bytes. */
  public static final long LARGEST = 1 << 20;

  private static final int DEEPEST = 20;
  private static final int MOST = 5000;

  private final Boundary boundary;

  /** Opens the files inside a boundary. */
  public ProjectFiles(Boundary boundary) {
    this.boundary = boundary;
  }

  /** Returns the files with their sizes in bytes, as JSON; no hidden ones, and no links. */
  public String list() {
    Map<String, Long> found = new TreeMap<>();
    try {
      Files.walkFileTree(boundary.root(), Set.<FileVisitOption>of(), DEEPEST, new Collector(found));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    ObjectNode json = new ObjectMapper().createObjectNode();
    ArrayNode files = json.putArray("files");
    found.entrySet().stream()
        .limit(MOST)
        .forEach(each -> files.addObject().put("file", each.getKey()).put("size", each.getValue()));
    return json.put("leftOut", Math.max(0, found.size() - MOST)).toPrettyString();
  }

  private final class Collector extends SimpleFileVisitor<Path> {

    private final Map<String, Long> found;

    Collector(Map<String, Long> found) {
      this.found = found;
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      boolean hidden = !folder.equals(boundary.root()) && isHidden(folder);
      return hidden ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      if (attributes.isRegularFile() && !isHidden(file)) {
        found.put(boundary.nameOf(file), attributes.size());
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException problem) {
      return FileVisitResult.CONTINUE;
    }
  }

  private static boolean isHidden(Path path) {
    return path.getFileName().toString().startsWith(".");
  }

  /**
   * Returns the text of a file that a client has named.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if it is outside, no text or too large
   */
  public String text(String name) {
    Path file = boundary.inside(name);
    for (Path part : boundary.root().relativize(file)) {
      if (isHidden(part)) {
        throw refusal(name, "A hidden file is not read.");
      }
    }
    return read(file, name);
  }

  /** Returns the text of a file inside. */
  static String read(Path file, String name) {
    try {
      if (!Files.isRegularFile(file)) {
        throw refusal(name, "There is no such file.");
      }
      if (Files.size(file) > LARGEST) {
        throw refusal(
            name, "A file of " + Files.size(file) + " bytes is not sent; the limit is " + LARGEST);
      }
      return StandardCharsets.UTF_8
          .newDecoder()
          .decode(ByteBuffer.wrap(Files.readAllBytes(file)))
          .toString();
    } catch (CharacterCodingException e) {
      throw refusal(name, "It is no text in UTF-8.");
    } catch (IOException e) {
      throw refusal(name, "It cannot be read: " + e.getMessage());
    }
  }

  private static RuntimeException refusal(String name, String message) {
    return McpRules.refusal(
        McpRules.FILE, name, message, "The resource eventchain://files lists what can be read.");
  }
}
