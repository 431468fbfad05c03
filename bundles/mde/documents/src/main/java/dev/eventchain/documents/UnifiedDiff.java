package dev.eventchain.documents;

import com.github.difflib.DiffUtils;
import com.github.difflib.UnifiedDiffUtils;
import com.github.difflib.patch.PatchFailedException;
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
  private static final String AFTER = "+++ b/";

  /** Stands below a last line without an end. */
  private static final String MARK = "\n\\ No newline at end of file";

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

  /**
   * Returns the text of a file after a change that {@link #of} has returned.
   *
   * @return empty if the text is another one where it changes
   */
  public static Optional<String> apply(String diff, String before) {
    try {
      List<String> after = UnifiedDiffUtils.parseUnifiedDiff(marked(diff)).applyTo(lines(before));
      return Optional.of(text(after));
    } catch (PatchFailedException | IndexOutOfBoundsException e) {
      return Optional.empty();
    }
  }

  /** Returns the name of the file that a change is about; empty if it does not say it. */
  public static Optional<String> file(String diff) {
    return diff.lines()
        .skip(1)
        .findFirst()
        .filter(line -> line.startsWith(AFTER))
        .map(line -> line.substring(AFTER.length()).replaceFirst("\t$", ""));
  }

  /** Returns the lines of a change, each with the mark below it. */
  private static List<String> marked(String diff) {
    List<String> lines = new ArrayList<>();
    for (String line : diff.split("\n", 0)) {
      if (MARK.equals("\n" + line) && !lines.isEmpty()) {
        lines.add(lines.remove(lines.size() - 1) + MARK);
      } else {
        lines.add(line);
      }
    }
    return lines;
  }

  private static String text(List<String> lines) {
    StringBuilder text = new StringBuilder();
    for (String line : lines) {
      boolean isOpen = line.endsWith(MARK);
      text.append(isOpen ? line.substring(0, line.length() - MARK.length()) : line + "\n");
    }
    return text.toString();
  }

  /** Returns the lines of a text, without line feeds; the last one may have its mark below it. */
  private static List<String> lines(String text) {
    List<String> lines = new ArrayList<>(List.of(text.split("\n", -1)));
    String last = lines.remove(lines.size() - 1);
    if (!last.isEmpty()) {
      lines.add(last + MARK);
    }
    return lines;
  }
}
