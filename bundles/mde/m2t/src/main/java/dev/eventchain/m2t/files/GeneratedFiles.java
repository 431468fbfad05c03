package dev.eventchain.m2t.files;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationContext.Trait;
import dev.eventchain.m2t.generation.GenerationResult.Printed;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.m2t.report.RunReport;
import dev.eventchain.m2t.text.OriginMarks;
import dev.eventchain.m2t.text.OutputBuffer;
import dev.eventchain.m2t.text.RunWriter;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputPath;
import dev.eventchain.output.ProtectedAreas;
import java.io.ByteArrayOutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;

/** Files of a run, with the protected areas of earlier files. */
public final class GeneratedFiles {

  /** Values of a {@code [file]} tag. */
  public record Tag(
      SourceLocation place,
      String name,
      FileMode mode,
      SourceLocation charsetPlace,
      Optional<String> charset) {}

  /** Block that is being written. */
  private static final class Block {
    private final GeneratedFile file;
    private final Tag tag;

    /** Id of the area that is being written; null if there is none. */
    private String area;

    Block(GeneratedFile file, Tag tag) {
      this.file = file;
      this.tag = tag;
    }
  }

  /** Text of a block, with its origins if they are recorded. */
  private record Written(String text, Optional<OriginMarks> marks) {}

  /** Name of blocks whose text is printed instead of written to a file. */
  private static final String CONSOLE = "stdout";

  private static final String OWN_NAMES =
      "Give each file its own name, or append: [file (name, true)].";

  private final RunReport report;
  private final RunWriter writer;
  private final Supplier<EObject> element;
  private final GenerationContext context;

  /** Files by their names, in the order of their first blocks, which is usually nearly sorted. */
  private final Map<String, GeneratedFile> files = new LinkedHashMap<>();

  private final UsedNames names = new UsedNames(files.keySet());
  private final Deque<Block> open = new ArrayDeque<>();
  private final List<Printed> printed = new ArrayList<>();
  private int begun;

  /**
   * Starts without files.
   *
   * @param element returns the current model element
   */
  public GeneratedFiles(
      RunReport report, RunWriter writer, Supplier<EObject> element, GenerationContext context) {
    this.report = report;
    this.writer = writer;
    this.element = element;
    this.context = context;
  }

  /**
   * Returns the complete files and the files of their lost areas. Reports the warnings about lost
   * areas.
   */
  public SortedMap<String, byte[]> contents() {
    SortedMap<String, byte[]> contents = new TreeMap<>(OutputFolder.WRITING_ORDER);
    for (GeneratedFile file : files.values()) {
      if (file.content() != null) {
        contents.put(file.path(), file.content());
      }
    }
    for (String path : List.copyOf(contents.keySet())) {
      GeneratedFile file = files.get(path);
      byte[] lost = file.isLeft() ? new byte[0] : lost(file);
      if (lost.length > 0) {
        contents.put(lostPath(file), lost);
      }
    }
    return contents;
  }

  /** Returns the printed texts. */
  public List<Printed> printed() {
    return List.copyOf(printed);
  }

  /** Returns the number of files and areas begun, which tells whether an evaluation began any. */
  public int begun() {
    return begun;
  }

  /** Writes a file from the text of a body. */
  public void write(Tag tag, Runnable body) {
    begun++;
    Optional<Charset> charset =
        tag.charset().flatMap(name -> FileCharsets.named(name, tag.charsetPlace(), report));
    if (tag.name().equals(CONSOLE)) {
      print(tag, body);
      return;
    }
    if (context.has(Trait.PRINTED_ONLY)) {
      refuse(tag, body);
      return;
    }
    OutputPath path = pathOf(tag.name());
    if (path.refused()) {
      var refused = path.refusal(tag.name());
      report.find(refused.kind(), tag.place(), refused.message(), refused.hint());
      return;
    }
    GeneratedFile known = known(path.value(), tag);
    if (known == null ? !hasRoom(path.value(), tag) : !goesOn(known, charset, tag)) {
      return;
    }
    GeneratedFile file =
        known == null ? begin(path.value(), charset.orElse(StandardCharsets.UTF_8), tag) : known;
    if (!file.isLeft()) {
      write(new Block(file, tag), body);
    }
  }

  /** Returns the path of a name; as in Acceleo, absolute names are below the output folder. */
  private static OutputPath pathOf(String name) {
    int slashes = 0;
    while (slashes < name.length() - 1 && name.charAt(slashes) == '/') {
      slashes++;
    }
    return OutputPath.of(name.substring(slashes));
  }

  /** Prints the text of a body. */
  private void print(Tag tag, Runnable body) {
    String text = textOutsideOfFiles(tag, body);
    if (!text.isEmpty()) {
      printed.add(new Printed(tag.place(), text));
    }
  }

  /** Reports a file without an output folder; blocks inside it may still print. */
  private void refuse(Tag tag, Runnable body) {
    String file = "The file '" + OutputPath.shown(tag.name()) + "'";
    String message = file + " is not written: there is no folder.";
    String hint = "Name an output folder, or print the text: [file ('stdout', false)].";
    report.find(GenerationRules.FILE_NO_FOLDER, tag.place(), message, hint);
    textOutsideOfFiles(tag, body);
  }

  private String textOutsideOfFiles(Tag tag, Runnable body) {
    GeneratedFile file = GeneratedFile.of(CONSOLE, StandardCharsets.UTF_8, Optional.empty());
    return textOf(new Block(file, tag), body).text();
  }

  /** Returns the existing file of a name, unless the block replaces it; null if there is none. */
  private GeneratedFile known(String path, Tag tag) {
    GeneratedFile known = files.get(path);
    if (known == null || !isReplaced(known, tag)) {
      return known;
    }
    String message = writtenBefore(known) + " That output is lost.";
    report.warn(GenerationRules.FILE_DUPLICATE, tag.place(), message, OWN_NAMES);
    files.remove(path);
    writer.forget(path);
    return null;
  }

  /** Returns whether a complete file is replaced by another of its name, as in Acceleo. */
  private boolean isReplaced(GeneratedFile known, Tag tag) {
    return tag.mode() == FileMode.OVERWRITE
        && known.content() != null
        && context.has(Trait.LENIENT);
  }

  private String writtenBefore(GeneratedFile known) {
    String where = "by the block at " + known.beginning(report);
    return "The file '" + known.path() + "' was already written in this run, " + where + ".";
  }

  /** Returns whether another block may continue an existing file. */
  private boolean goesOn(GeneratedFile known, Optional<Charset> charset, Tag tag) {
    if (tag.mode() == FileMode.OVERWRITE) {
      report.find(GenerationRules.FILE_DUPLICATE, tag.place(), writtenBefore(known), OWN_NAMES);
      return false;
    }
    if (tag.mode() == FileMode.CREATE || known.isLeft()) {
      return false;
    }
    if (charset.isPresent() && !charset.get().equals(known.charset())) {
      report.find(
          FileCharsets.ID,
          tag.charsetPlace(),
          "The file '"
              + known.path()
              + "' was started in "
              + known.charset()
              + " and cannot continue in "
              + charset.get()
              + ".",
          "Write '" + known.charset() + "', or leave the charset out.");
      return false;
    }
    return true;
  }

  /** Returns whether a file name does not collide with the other files of the run. */
  private boolean hasRoom(String path, Tag tag) {
    Optional<String> collision = names.collisionOf(path);
    collision.ifPresent(
        problem ->
            report.find(
                GenerationRules.FILE_DUPLICATE,
                tag.place(),
                problem,
                "Give files and folders different names."));
    return collision.isEmpty();
  }

  private GeneratedFile begin(String path, Charset charset, Tag tag) {
    Optional<byte[]> before = context.earlier().apply(path);
    Optional<String> text = before.flatMap(content -> FileCharsets.decoded(content, charset));
    boolean unreadable = before.isPresent() && text.isEmpty() && ProtectedAreas.anyIn(before.get());
    boolean stays = before.isPresent() && tag.mode() == FileMode.CREATE;
    if (unreadable && !stays) {
      report.find(
          FileCharsets.ID,
          tag.charsetPlace(),
          "The earlier file '"
              + path
              + "' has protected areas but is not in "
              + charset
              + ", so they cannot be kept; the file is left as it is.",
          "Save the file in " + charset + ".");
    }
    GeneratedFile file =
        stays || unreadable
            ? GeneratedFile.left(path, charset, before.get())
            : GeneratedFile.of(path, charset, text);
    files.put(path, file);
    names.add(path);
    file.begunBy(tag.place(), element.get());
    return file;
  }

  private void write(Block block, Runnable body) {
    GeneratedFile file = block.file;
    Written written = textOf(block, body);
    String merged = file.merged(written.text(), written.marks(), block.tag.place(), report, writer);
    boolean starts = file.content() == null;
    file.add(FileCharsets.bytes(merged, starts, file, block.tag.charsetPlace(), report));
    file.noteLosses(lostPath(file), report);
  }

  private Written textOf(Block block, Runnable body) {
    OutputBuffer output = writer.output();
    OutputBuffer.Part part = output.beginText();
    open.push(block);
    try {
      byte[] before = block.file.content();
      if (before != null && before.length > 0) {
        writer.appendOwn("\n");
      }
      body.run();
      return new Written(output.textOf(part), output.marksOf(part));
    } finally {
      output.cut(part);
      open.pop();
    }
  }

  /** Returns the path of the file for lost areas. */
  private String lostPath(GeneratedFile file) {
    return file.path() + ProtectedAreas.LOST;
  }

  /** Returns the lost areas, earlier and new ones. */
  private byte[] lost(GeneratedFile file) {
    byte[] before = context.earlier().apply(lostPath(file)).orElse(new byte[0]);
    if (!file.losesAreas()) {
      return before;
    }
    file.losses().forEach(report::add);
    String known = new String(before, file.charset());
    ByteArrayOutputStream lost = new ByteArrayOutputStream();
    lost.writeBytes(before);
    for (String area : file.lost()) {
      // A file that a user keeps unchanged loses the same area in each run.
      if (!known.contains(area)) {
        lost.writeBytes(
            lost.size() == 0
                ? area.getBytes(file.charset())
                : FileCharsets.continued(area, file.charset()));
      }
    }
    return lost.toByteArray();
  }

  /** Begins an area; returns false, after a report, if no area of this id is possible here. */
  public boolean beginArea(SourceLocation place, String id) {
    begun++;
    Block block = open.peek();
    if (block != null
        && block.area == null
        && !FileCharsets.agreesWithAscii(block.file.charset())) {
      report.find(
          FileCharsets.ID,
          block.tag.charsetPlace(),
          "Protected areas cannot be found again in "
              + block.file.charset()
              + ", so '"
              + OutputPath.shown(id)
              + "' is left out.",
          "Write the file in UTF-8, or without protected areas.");
      return false;
    }
    String problem = problem(block, id);
    if (!problem.isEmpty()) {
      GeneratedFile.refuse(id, problem, place, report);
      return false;
    }
    block.area = id;
    return true;
  }

  private String problem(Block block, String id) {
    if (block == null) {
      return "is outside any file";
    }
    if (block.area != null) {
      return "is inside the area '" + OutputPath.shown(block.area) + "'";
    }
    if (id.isEmpty() || id.indexOf('\n') >= 0 || id.indexOf('\r') >= 0) {
      return "has an id that is not a single line of text";
    }
    return block.file.has(id, writer.output()) ? "has the same id as another area of the file" : "";
  }

  /** Notes that the mark of the current area follows. */
  public void startArea() {
    Block block = open.element();
    block.file.begin(block.area, writer.output());
  }

  /** Ends the current area. */
  public void endArea() {
    open.element().area = null;
  }
}
