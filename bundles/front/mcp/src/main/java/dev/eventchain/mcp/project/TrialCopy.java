package dev.eventchain.mcp.project;

import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Set;
import java.util.stream.Stream;

/**
 * A copy of a project with a proposal, on which it is checked.
 *
 * @param folder a temporary folder in the place of the server's
 */
public record TrialCopy(Path folder) implements AutoCloseable {

  /** Results that no stage reads. */
  private static final Set<String> LEFT_OUT = Set.of("mcap", "campaigns", "searches");

  private static final long LARGEST = 256 << 20;

  /** Copies a project to where it is in the server's folder, and changes the copy. */
  public static TrialCopy of(Boundary boundary, Proposal proposal) {
    try {
      TrialCopy copy = new TrialCopy(Files.createTempDirectory("eventchain-proposal"));
      try {
        Path target = copy.folder.resolve(boundary.nameOf(proposal.project())).normalize();
        copy.fill(proposal.project(), target);
        proposal.writeTo(target);
        return copy;
      } catch (RuntimeException | IOException e) {
        copy.close();
        throw e;
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void fill(Path project, Path target) throws IOException {
    long size = 0;
    try (Stream<Path> files = Files.walk(project)) {
      for (Path file : files.filter(each -> isCopied(project, each)).toList()) {
        Path place = target.resolve(project.relativize(file).toString());
        if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
          Files.createDirectories(place);
        } else if (Files.isRegularFile(file)) {
          size += Files.size(file);
          requireSmall(size);
          Files.copy(file, place);
        } else {
          throw McpRules.refusal(
              McpRules.CHANGE,
              project.relativize(file).toString(),
              "It is no file, and no copy can be made of it.",
              "Make the change, and validate the project itself.");
        }
      }
    }
  }

  private static void requireSmall(long size) {
    if (size > LARGEST) {
      throw McpRules.refusal(
          McpRules.CHANGE,
          "",
          "The project is too large to be copied: more than " + LARGEST + " bytes.",
          "Make the change, and validate the project itself.");
    }
  }

  private static boolean isCopied(Path project, Path file) {
    Path relative = project.relativize(file);
    boolean result = relative.startsWith(ProjectLayout.OUTPUT) && relative.getNameCount() > 1;
    return !relative.getName(0).toString().startsWith(".")
        && !(result && LEFT_OUT.contains(relative.getName(1).toString()));
  }

  @Override
  public void close() {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
