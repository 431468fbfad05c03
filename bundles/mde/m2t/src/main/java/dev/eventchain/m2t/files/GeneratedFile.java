package dev.eventchain.m2t.files;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.m2t.report.RunReport;
import dev.eventchain.m2t.syntax.SyntaxRules;
import dev.eventchain.m2t.text.OriginMarks;
import dev.eventchain.m2t.text.OutputBuffer;
import dev.eventchain.m2t.text.RunWriter;
import dev.eventchain.output.OutputPath;
import dev.eventchain.output.ProtectedAreas;
import dev.eventchain.output.ProtectedAreas.Area;
import java.nio.charset.Charset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;

/** A file of a run, written by one or more blocks, with the protected areas of the earlier file. */
final class GeneratedFile {

  /** Protected area of the earlier file. */
  private static final class Earlier {
    private final String line;
    private final String content;
    private boolean taken;
    private Diagnostic loss;

    Earlier(Area area, String text) {
      line = area.line();
      content = area.content(text);
    }

    String id() {
      return line.strip();
    }

    /** Returns the area as it was in the file. */
    String text() {
      return ProtectedAreas.START + line + content + ProtectedAreas.END + "\n";
    }
  }

  private final String path;
  private final Charset charset;
  private final boolean left;
  private final List<Earlier> earlier = new ArrayList<>();
  private final Map<String, List<Earlier>> earlierById = new HashMap<>();

  /** Ids of the areas that templates began, with their offsets in the output of the run. */
  private final Map<String, Integer> begun = new HashMap<>();

  /** Ids of the areas in complete blocks. */
  private final Set<String> written = new HashSet<>();

  private boolean lossesNoted;
  private byte[] content;
  private SourceLocation block;

  /** Current element of the block that began the file; null if there is none. */
  private EObject element;

  private GeneratedFile(String path, Charset charset, boolean left) {
    this.path = path;
    this.charset = charset;
    this.left = left;
  }

  /** Returns a file that replaces an earlier one, if there is one. */
  static GeneratedFile of(String path, Charset charset, Optional<String> earlierText) {
    GeneratedFile file = new GeneratedFile(path, charset, false);
    String text = earlierText.orElse("");
    for (Area found : ProtectedAreas.in(text)) {
      Earlier area = new Earlier(found, text);
      file.earlier.add(area);
      file.earlierById.computeIfAbsent(area.id(), any -> new ArrayList<>()).add(area);
    }
    return file;
  }

  /** Returns a file that is left unchanged. */
  static GeneratedFile left(String path, Charset charset, byte[] content) {
    GeneratedFile file = new GeneratedFile(path, charset, true);
    file.content = content;
    return file;
  }

  String path() {
    return path;
  }

  Charset charset() {
    return charset;
  }

  /**
   * Notes the block that begins the file.
   *
   * @param at the current element; null if there is none
   */
  void begunBy(SourceLocation place, EObject at) {
    block = place;
    element = at;
  }

  /** Returns the location of the block that began the file, and its element. */
  String beginning(RunReport report) {
    return element == null ? block.toString() : block + " for " + report.nameOf(element);
  }

  /** Returns whether the earlier file is left unchanged. */
  boolean isLeft() {
    return left;
  }

  /** Returns the content so far; null if no block is complete. */
  byte[] content() {
    return content;
  }

  /** Appends the content of another block. */
  void add(byte[] more) {
    if (content == null) {
      content = more;
    } else {
      int length = content.length;
      content = Arrays.copyOf(content, length + more.length);
      System.arraycopy(more, 0, content, length, more.length);
    }
  }

  /** Notes that an area starts at the end of the output; its text may be dropped later. */
  void begin(String id, OutputBuffer output) {
    begun.put(id, output.mark().start());
  }

  /** Returns whether the file has an area of this id so far. */
  boolean has(String id, OutputBuffer output) {
    Integer start = begun.get(id);
    return written.contains(id)
        || (start != null && output.hasAt(start, ProtectedAreas.START + id));
  }

  /**
   * Returns the text of a block with the earlier contents of its areas, which neither indentation
   * nor operations may change. Adds the text to the trace.
   *
   * @param place the location of the block
   */
  String merged(
      String text,
      Optional<OriginMarks> marks,
      SourceLocation place,
      RunReport report,
      RunWriter writer) {
    List<Area> areas = ProtectedAreas.in(text);
    if (areas.isEmpty()) {
      marks.ifPresent(origins -> writer.tracing().file(path, text, origins));
      return text;
    }
    OutputBuffer merged = new OutputBuffer(marks.isPresent());
    OutputBuffer.Part all = merged.mark();
    int from = 0;
    for (Area area : areas) {
      check(area, text, place, report);
      Optional<Earlier> kept = take(area.line().strip());
      if (kept.isPresent()) {
        append(text, from, area.start(), marks, merged);
        String content = kept.get().content;
        append(content, 0, content.length(), marks.map(any -> OriginMarks.NOWHERE), merged);
        from = area.end();
      }
    }
    append(text, from, text.length(), marks, merged);
    String whole = merged.textOf(all);
    merged.marksOf(all).ifPresent(origins -> writer.tracing().file(path, whole, origins));
    return whole;
  }

  private static void append(
      String text, int from, int to, Optional<OriginMarks> marks, OutputBuffer merged) {
    String part = text.substring(from, to);
    if (marks.isEmpty()) {
      merged.append(part);
    } else {
      merged.append(part, marks.get().between(from, to));
    }
  }

  /** Reports invalid areas that come from variables or operations. */
  private void check(Area area, String text, SourceLocation place, RunReport report) {
    String id = idOf(area.line().strip());
    if (!written.add(id)) {
      refuse(id, "has the same id as another area of the file", place, report);
    }
    int inner = text.indexOf(ProtectedAreas.START, area.start());
    if (inner >= 0 && inner < area.end()) {
      int start = inner + ProtectedAreas.START.length();
      String line = text.substring(start, ProtectedAreas.endOfLine(text, start)).strip();
      if (begun.containsKey(idOf(line))) {
        refuse(idOf(line), "is inside the area '" + OutputPath.shown(id) + "'", place, report);
      }
    }
  }

  static void refuse(String id, String problem, SourceLocation place, RunReport report) {
    report.find(
        SyntaxRules.PROTECTED_ID,
        place,
        "The protected area '" + OutputPath.shown(id) + "' " + problem + ".",
        "Give each area of a file its own id.");
  }

  /** Returns the longest known id that a line starts with; templates may write more after it. */
  private String idOf(String line) {
    for (int end = line.length(); end > 0; end--) {
      String start = line.substring(0, end);
      if (begun.containsKey(start)) {
        return start;
      }
    }
    return line;
  }

  private Optional<Earlier> take(String line) {
    Optional<Earlier> found = untaken(line).or(() -> untaken(idOf(line)));
    found.ifPresent(area -> area.taken = true);
    return found;
  }

  private Optional<Earlier> untaken(String id) {
    return earlierById.getOrDefault(id, List.of()).stream().filter(area -> !area.taken).findFirst();
  }

  /** Prepares warnings, for the current element, about areas missing from the first block. */
  void noteLosses(String lostPath, RunReport report) {
    if (lossesNoted) {
      return;
    }
    lossesNoted = true;
    for (Earlier area : earlier) {
      if (!area.taken) {
        area.loss =
            report.finding(
                GenerationRules.PROTECTED_LOST,
                SourceLocation.of(path),
                "The protected area '"
                    + OutputPath.shown(area.id())
                    + "' is no longer generated; its content was saved in '"
                    + lostPath
                    + "'.",
                "Move the content to where it belongs now, and delete the file.");
      }
    }
  }

  /** Returns whether there are areas that no block contains. */
  boolean losesAreas() {
    return earlier.stream().anyMatch(area -> !area.taken);
  }

  /** Returns the warnings about areas that no block contains. */
  List<Diagnostic> losses() {
    return earlier.stream().filter(area -> !area.taken).map(area -> area.loss).toList();
  }

  /** Returns the areas that no block contains, each as it was in the file. */
  List<String> lost() {
    return earlier.stream().filter(area -> !area.taken).map(Earlier::text).toList();
  }
}
