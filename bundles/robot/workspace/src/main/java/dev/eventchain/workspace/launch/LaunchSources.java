package dev.eventchain.workspace.launch;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Files and packages that launch files refer to.
 *
 * @param files elements of all launch files by their names in the workspace
 * @param packages the folders of packages in the workspace, by the names of packages
 * @param texts returns the text of a file by its name in the workspace
 */
public record LaunchSources(
    Map<String, List<LaunchElement>> files,
    Map<String, String> packages,
    Function<String, Optional<SourceText>> texts) {

  private static final Pattern SHARE =
      Pattern.compile("\\$\\(find-pkg-share '?([^)' ]+)'?\\)/+(.+)");
  private static final Pattern HERE = Pattern.compile("\\$\\(dirname\\)/+(.+)");

  /**
   * Returns the name in the workspace of a file that launch names.
   *
   * @param from the launch file
   */
  Optional<String> located(String path, String from) {
    Matcher share = SHARE.matcher(path);
    if (share.matches()) {
      String below = share.group(2);
      return Optional.ofNullable(packages.get(share.group(1)))
          .map(folder -> Path.of(folder).resolve(below).normalize().toString());
    }
    Matcher here = HERE.matcher(path);
    return here.matches()
        ? Optional.of(Path.of(from).resolveSibling(here.group(1)).normalize().toString())
        : Optional.empty();
  }
}
