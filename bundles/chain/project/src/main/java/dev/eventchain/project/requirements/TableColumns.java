package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Columns of a table that hold ids, texts and what else is known of requirements, by the names in
 * its header.
 */
final class TableColumns {

  private static final Set<String> IDS = Set.of("id", "identifier");

  /** Names of columns that are those of ids only if these look like some. */
  private static final Set<String> NUMBERS =
      Set.of(
          "req",
          "requirement",
          "no",
          "nr",
          "number",
          "#",
          "ref",
          "reference",
          "code",
          "key",
          "uid",
          "tag");

  /** Names of columns of texts; those of the first list that the header has count. */
  private static final List<Set<String>> TEXTS =
      List.of(
          Set.of("text", "statement", "requirement", "description", "specification"),
          Set.of("definition", "content", "shall"),
          Set.of("title", "name", "summary"));

  private final List<String> header;
  private final RequirementSource.Fields fields;
  private final int id;
  private final List<Integer> texts;

  TableColumns(TextBlock.Table table, RequirementSource.Fields fields) {
    this.header = table.header().stream().map(TableColumns::plain).toList();
    this.fields = fields;
    this.id = idColumn(table);
    this.texts = textColumns();
  }

  /** Returns a name without markup, and without what says that it is one of requirements. */
  private static String plain(String name) {
    String plain = name.replaceAll("[*_`:.]", " ").strip().toLowerCase(Locale.ROOT);
    String short_ = plain.replaceFirst("^(req|requirements?)\\s+", "").replaceAll("\\s+", " ");
    return short_.isEmpty() ? plain : short_;
  }

  private int idColumn(TextBlock.Table table) {
    if (fields.id().isPresent()) {
      return header.indexOf(plain(fields.id().get()));
    }
    for (int i = 0; i < header.size(); i++) {
      int column = i;
      boolean named = IDS.contains(header.get(i)) || header.get(i).matches("req ?id");
      boolean numbered =
          NUMBERS.contains(header.get(i))
              && table.rows().stream().anyMatch(row -> TextIds.isId(cell(row, column)));
      if (named || numbered) {
        return i;
      }
    }
    return -1;
  }

  private List<Integer> textColumns() {
    List<Integer> found = new ArrayList<>();
    if (fields.text().isPresent()) {
      found.add(header.indexOf(plain(fields.text().get())));
      found.remove(Integer.valueOf(-1));
      return found;
    }
    for (Set<String> names : TEXTS) {
      for (int i = 0; i < header.size() && (found.isEmpty() || names == TEXTS.get(0)); i++) {
        if (i != id && names.contains(header.get(i))) {
          found.add(i);
        }
      }
    }
    return found;
  }

  boolean hasIds() {
    return id >= 0;
  }

  boolean hasTexts() {
    return !texts.isEmpty();
  }

  /** Returns the names of several columns that may be that of the texts; else empty. */
  List<String> ambiguous() {
    return texts.size() > 1 ? texts.stream().map(header::get).toList() : List.of();
  }

  String id(TextBlock.Row row) {
    return TextIds.plain(cell(row, id));
  }

  String text(TextBlock.Row row) {
    return cell(row, texts.get(0));
  }

  /** Returns whether a row has anything but what is in its column of ids. */
  boolean isTitle(TextBlock.Row row) {
    for (int i = 0; i < row.cells().size(); i++) {
      if (i != id && !row.cells().get(i).isBlank()) {
        return false;
      }
    }
    return true;
  }

  boolean isTooLong(TextBlock.Row row) {
    return row.cells().size() > header.size();
  }

  /** Adds the type, the status, the tags and the parents that a row says. */
  void describe(TextBlock.Row row, Item item, SourceLocation place) {
    named(row, "type").ifPresent(each -> item.type = Optional.of(each));
    item.status = named(row, fields.status().map(TableColumns::plain).orElse("status"));
    item.tags =
        named(row, fields.tags().map(TableColumns::plain).orElse("tags"))
            .map(Reading::parts)
            .orElse(List.of());
    List<String> parents =
        fields.parents().isEmpty()
            ? TextIds.PARENTS
            : fields.parents().stream().map(TableColumns::plain).toList();
    for (String name : parents) {
      named(row, name)
          .map(Reading::parts)
          .orElse(List.of())
          .forEach(each -> item.addParent(TextIds.plain(each), place));
    }
  }

  private Optional<String> named(TextBlock.Row row, String name) {
    int column = header.indexOf(name);
    return column < 0
        ? Optional.empty()
        : Optional.of(cell(row, column)).filter(text -> text.matches(".*[A-Za-z0-9].*"));
  }

  private static String cell(TextBlock.Row row, int column) {
    return column < row.cells().size() ? row.cells().get(column) : "";
  }
}
