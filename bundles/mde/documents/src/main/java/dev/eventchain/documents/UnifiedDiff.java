package dev.eventchain.documents;

import com.github.difflib.DiffUtils;
import com.github.difflib.UnifiedDiffUtils;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The change of a file in the unified format, as {@code patch -p1} and {@code git apply} take it:
 * carriage returns stay at the ends of lines, since both compare them, and a last line without an
 * end is marked.
 */
public final class UnifiedDiff {

  private static final int CONTEXT = 3;

  private UnifiedDiff() {}

  /**
   * Returns the change of a file.
   *
   * @param name its path in the project, with slashes
   * @param before its text; empty for a new file
   * @return lines that end in a line feed; an empty text if nothing changes, or a new file is empty
   */
  public static String of(String name, Optional<String> before, String after) {
    List<String> old = before.map(UnifiedDiff::lines).orElse(List.of());
    String end = name.indexOf(' ') < 0 ? "" : "\t"; // without it, patch ends the name at the space
    String from = before.isPresent() ? "a/" + name + end : "/dev/null";
    List<String> diff =
        UnifiedDiffUtils.generateUnifiedDiff(
            from, "b/" + name + end, old, DiffUtils.diff(old, lines(after)), CONTEXT);
    return diff.isEmpty() ? "" : String.join("\n", diff) + "\n";
  }

  /** Returns the lines of a text, without line feeds; the last one may have its mark below it. */
  private static List<String> lines(String text) {
    List<String> lines = new ArrayList<>(List.of(text.split("\n", -1)));
    String last = lines.remove(lines.size() - 1);
    if (!last.isEmpty()) {
      lines.add(last + "\n\\ No newline at end of file");
    }
    return lines;
  }
}
