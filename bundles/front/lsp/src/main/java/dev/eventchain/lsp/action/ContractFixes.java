package dev.eventchain.lsp.action;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Changes that make the two sides of a topic agree, as the hints of findings about units and
 * qualities of service name them, in a model.
 */
record ContractFixes(Workspace files) {

  private static final String UNIT_MISMATCH = "contract.unit.mismatch";
  private static final String QOS_INCOMPATIBLE = "contract.qos.incompatible";

  private static final Pattern UNITS =
      Pattern.compile("has '.+?' of \\S+ in (.+), but .+ has it in (.+)\\.");

  private static final Pattern POLICY =
      Pattern.compile(
          "\\b(request|offer) (reliability|durability|liveliness) ([A-Z_]+) in ([^,;.]+)");

  private static final Pattern START_TAG =
      Pattern.compile("<(?:[^<>\"']++|\"[^<\"]*+\"|'[^<']*+')*+>");

  /** Returns what can be changed; nothing if a text is not as the finding says. */
  List<Fix> of(Path file, Diagnostic finding) {
    return switch (finding.id()) {
      case UNIT_MISMATCH -> unit(file, finding).map(List::of).orElse(List.of());
      case QOS_INCOMPATIBLE -> policies(file, finding);
      default -> List.of();
    };
  }

  private Optional<Fix> unit(Path file, Diagnostic finding) {
    Matcher units = UNITS.matcher(finding.message());
    if (!units.find()) {
      return Optional.empty();
    }
    String here = units.group(1);
    String there = units.group(2);
    boolean isUnknown = finding.hint().startsWith("'" + here + "' is not a known unit");
    boolean isConverted = finding.hint().matches("(?s)(Give|Take) it in .*");
    if (!isUnknown && !isConverted) {
      return Optional.empty(); // one side is a different quantity, or the other one is misspelt
    }
    String title =
        isUnknown
            ? "Change the unit to '" + there + "'"
            : "Change the unit to '" + there + "', which the component's code must follow";
    return text(file, finding.location())
        .flatMap(at -> at.replaced("unit", here, there))
        .map(edit -> new Fix(title, edit, isUnknown));
  }

  private List<Fix> policies(Path file, Diagnostic finding) {
    List<Fix> fixes = new ArrayList<>();
    Matcher policy = POLICY.matcher(finding.hint());
    boolean isOnlyOne = !finding.hint().contains(", or offer ");
    while (policy.find()) {
      boolean isHere = isOnlyOne || policy.group(1).equals("request");
      Optional<SourceLocation> there = finding.related().stream().findFirst();
      Optional<At> place = isHere ? text(file, finding.location()) : there.flatMap(this::text);
      String title = policy.group().substring(0, 1).toUpperCase(Locale.ROOT);
      place
          .flatMap(at -> at.withPolicy(policy.group(2), policy.group(3)))
          .ifPresent(
              edit -> fixes.add(new Fix(title + policy.group().substring(1), edit, isOnlyOne)));
    }
    return fixes;
  }

  private Optional<At> text(SourceLocation place) {
    return place.file().isEmpty()
        ? Optional.empty()
        : text(Path.of(place.file()).toAbsolutePath().normalize(), place);
  }

  private Optional<At> text(Path file, SourceLocation place) {
    Optional<SourceText> text = place.line() < 1 ? Optional.empty() : files.text(file);
    return text.filter(it -> !file.toString().endsWith(".json"))
        .map(it -> new At(file, it.text(), it.offset(place.line(), Math.max(1, place.column()))));
  }

  /** A place in the start tag of an element. */
  private record At(Path file, String text, int offset) {

    private Optional<FileEdit> edit(int start, int end, String by) {
      return Optional.of(new FileEdit(file, new TextLines(text).range(start, end), by));
    }

    /** Replaces a value, if it is there. */
    private Optional<FileEdit> replaced(String attribute, String value, String by) {
      Optional<Matcher> found = attribute(attribute);
      return found
          .filter(it -> it.group(2).strip().equals(escaped(value)))
          .flatMap(it -> edit(it.start(2), it.end(2), escaped(by)));
    }

    private static String escaped(String value) {
      return value.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
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

    private Optional<FileEdit> withPolicy(String policy, String value) {
      Optional<Matcher> data = tag().filter(it -> it.group().matches("(?s)<data\\s.*"));
      if (data.isPresent() && data.get().group().endsWith("/>")) {
        String child = "><qos %s=\"%s\"/></data>".formatted(policy, value);
        return edit(data.get().end() - 2, data.get().end(), child);
      }
      Matcher child = Pattern.compile("\\s*(?=<qos\\b)").matcher(text);
      int from = data.map(Matcher::end).orElse(text.length());
      return child.region(from, text.length()).lookingAt()
          ? new At(file, text, child.end()).withAttribute(policy, value)
          : Optional.empty();
    }

    private Optional<FileEdit> withAttribute(String policy, String value) {
      Optional<Matcher> tag = tag();
      if (tag.isEmpty()) {
        return Optional.empty();
      }
      Optional<Matcher> present = attribute(policy);
      if (present.isPresent()) {
        return edit(present.get().start(2), present.get().end(2), value);
      }
      int end = tag.get().end() - (tag.get().group().endsWith("/>") ? 2 : 1);
      while (Character.isWhitespace(text.charAt(end - 1))) {
        end--;
      }
      return edit(end, end, " " + policy + "=\"" + value + "\"");
    }
  }
}
