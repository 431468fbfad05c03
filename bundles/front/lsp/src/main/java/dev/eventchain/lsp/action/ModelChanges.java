package dev.eventchain.lsp.action;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.ModelChange;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.TextFix;
import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Changes of models and of JSON and YAML that findings propose, as edits of their texts. */
record ModelChanges(Workspace files) {

  private static final Pattern START_TAG =
      Pattern.compile("<(?:[^<>\"']++|\"[^<\"]*+\"|'[^<']*+')*+>");

  /** Returns what can be changed; nothing if a text is not as the finding says. */
  List<Fix> of(Path file, Diagnostic finding) {
    List<Fix> fixes = new ArrayList<>();
    for (ModelChange change : finding.changes()) {
      text(file, finding, change.place())
          .flatMap(at -> at.changed(change))
          .ifPresent(edit -> fixes.add(new Fix(change.title(), edit, change.certain())));
    }
    return fixes;
  }

  private Optional<At> text(Path file, Diagnostic finding, SourceLocation place) {
    if (place.equals(finding.location())) {
      return text(file, place);
    }
    return place.file().isEmpty()
        ? Optional.empty()
        : text(Path.of(place.file()).toAbsolutePath().normalize(), place);
  }

  private Optional<At> text(Path file, SourceLocation place) {
    Optional<SourceText> text = place.line() < 1 ? Optional.empty() : files.text(file);
    return text.map(
        it -> new At(file, it.text(), it.offset(place.line(), Math.max(1, place.column()))));
  }

  /** A place in the start tag of an element, or at a value of JSON or YAML. */
  private record At(Path file, String text, int offset) {

    Optional<FileEdit> changed(ModelChange change) {
      String name = file.toString();
      if (name.endsWith(".json")) {
        return DocumentChanges.json(text, offset, change).flatMap(this::edit);
      } else if (name.matches(".*\\.ya?ml")) {
        return DocumentChanges.yaml(text, offset, change).flatMap(this::edit);
      }
      return change.child().isEmpty()
          ? replaced(change.attribute(), change.from(), change.to())
          : withChild(change.child(), change.attribute(), change.to());
    }

    private Optional<FileEdit> edit(TextFix fix) {
      return edit(fix.start(), fix.end(), fix.by());
    }

    private Optional<FileEdit> edit(int start, int end, String by) {
      return Optional.of(new FileEdit(file, new TextLines(text).range(start, end), by));
    }

    /** Replaces a value, if it is there. */
    private Optional<FileEdit> replaced(String attribute, String value, String by) {
      Optional<Matcher> found = attribute(attribute);
      return found
          .filter(it -> plain(it.group(2)).equals(value))
          .flatMap(it -> edit(it.start(2), it.end(2), escaped(by)));
    }

    private static String escaped(String value) {
      return value
          .replace("&", "&amp;")
          .replace("<", "&lt;")
          .replace("\"", "&quot;")
          .replace("'", "&apos;");
    }

    /** Returns the value that is written, without the entities for characters other than these. */
    private static String plain(String written) {
      return written
          .strip()
          .replace("&apos;", "'")
          .replace("&quot;", "\"")
          .replace("&lt;", "<")
          .replace("&amp;", "&");
    }

    /** Returns the start tag around the place, or at it. */
    private Optional<Matcher> tag() {
      int begin = text.lastIndexOf('<', Math.min(offset, text.length() - 1));
      Matcher tag = START_TAG.matcher(text).region(Math.max(0, begin), text.length());
      return begin >= 0 && tag.lookingAt() ? Optional.of(tag) : Optional.empty();
    }

    private Optional<Matcher> attribute(String name) {
      Optional<Matcher> tag = tag();
      Matcher attribute = Pattern.compile("\\s" + name + "\\s*=\\s*([\"'])(.*?)\\1").matcher(text);
      return tag.map(it -> attribute.region(it.start(), it.end())).filter(Matcher::find);
    }

    private Optional<FileEdit> withChild(String child, String attribute, String value) {
      Optional<Matcher> parent = tag();
      String tag = parent.map(Matcher::group).orElse("");
      String name = tag.replaceFirst("(?s)<([\\w:.-]+)\\s.*", "$1");
      if (name.equals(tag) || name.equals(child)) {
        return Optional.empty();
      }
      int end = parent.orElseThrow().end();
      if (tag.endsWith("/>")) {
        String added = "><%s %s=\"%s\"/></%s>".formatted(child, attribute, escaped(value), name);
        return edit(end - 2, end, added);
      }
      Matcher present = Pattern.compile("\\s*(?=<" + child + "\\b)").matcher(text);
      return present.region(end, text.length()).lookingAt()
          ? new At(file, text, present.end()).withAttribute(attribute, value)
          : Optional.empty();
    }

    private Optional<FileEdit> withAttribute(String name, String value) {
      Optional<Matcher> tag = tag();
      if (tag.isEmpty()) {
        return Optional.empty();
      }
      Optional<Matcher> present = attribute(name);
      if (present.isPresent()) {
        return edit(present.get().start(2), present.get().end(2), escaped(value));
      }
      int end = tag.get().end() - (tag.get().group().endsWith("/>") ? 2 : 1);
      while (Character.isWhitespace(text.charAt(end - 1))) {
        end--;
      }
      return edit(end, end, " " + name + "=\"" + escaped(value) + "\"");
    }
  }
}
