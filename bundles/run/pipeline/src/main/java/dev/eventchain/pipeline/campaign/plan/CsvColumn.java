package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.CsvRow;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Values from a column of a table: the first line has the names. Texts may stand for numbers. */
final class CsvColumn {

  private static final List<BigDecimal> NOTHING = List.of(BigDecimal.ZERO);

  private static final NumberRange ANY = NumberRange.of(-1e12, 1e12);

  private final Map<String, BigDecimal> numbers = new HashMap<>();
  private final Path campaign;
  private final ObjectReader part;

  CsvColumn(Path campaign, ObjectReader part) {
    this.campaign = campaign;
    this.part = part;
  }

  /** Returns the values, in the order of the table. */
  Levels read() {
    part.object("numbers").ifPresent(this::readNumbers);
    return new Levels.Column(part.text("csv").orElse(""), cells());
  }

  private void readNumbers(ObjectReader section) {
    for (String text : section.names()) {
      double number = section.requiredNumber(text, ANY);
      numbers.put(text, BigDecimal.valueOf(number).stripTrailingZeros());
    }
  }

  private List<BigDecimal> cells() {
    String name = part.requiredText("csv");
    String column = part.requiredText("column");
    if (name.isEmpty() || column.isEmpty()) {
      return NOTHING;
    }
    try {
      Path file = campaign.resolveSibling(name);
      if (!Files.exists(file)) {
        String message = "There is no file '" + name + "'.";
        part.find(
            Diagnostic.of(CampaignRules.FACTOR, message, part.at("csv"))
                .withHint("Name it by its path from the campaign file."));
        return NOTHING;
      }
      return cells(name, column, SourceText.read(file));
    } catch (InvalidPathException e) {
      part.find(CampaignRules.VALUE_RANGE, "No file can be called like this.", part.at("csv"));
      return NOTHING;
    }
  }

  private List<BigDecimal> cells(String name, String column, SourceText text) {
    List<CsvRow> rows = CsvRow.rows(text.text());
    List<String> names = rows.isEmpty() ? List.of() : rows.get(0).cells();
    int index = names.indexOf(column);
    if (index < 0) {
      String message = name + " has no column '" + column + "'.";
      part.find(
          Diagnostic.of(CampaignRules.VALUE_RANGE, message, part.at("column"))
              .withHint(NearestName.hint(column, names)));
      return NOTHING;
    }
    return values(name, column, rows.subList(1, rows.size()), index);
  }

  private static BigDecimal number(String cell) {
    BigDecimal number = new BigDecimal(cell);
    if (!LevelsReader.isUsual(number)) {
      throw new NumberFormatException("too large or too long");
    }
    return number.stripTrailingZeros();
  }

  private List<BigDecimal> values(String name, String column, List<CsvRow> rows, int index) {
    List<BigDecimal> values = new ArrayList<>();
    for (CsvRow row : rows) {
      String cell = index < row.cells().size() ? row.cells().get(index).strip() : "";
      try {
        BigDecimal number = numbers.get(cell);
        values.add(number != null ? number : number(cell));
      } catch (NumberFormatException e) {
        String line = "Line " + row.line() + " of " + name;
        String message = line + " has no number for '" + column + "', but '" + cell + "'.";
        part.find(
            Diagnostic.of(CampaignRules.VALUE_TYPE, message, part.at("csv"))
                .withHint("Give texts numbers: `numbers: {dry: 1, wet: 2}`."));
        return NOTHING;
      }
    }
    if (values.isEmpty()) {
      part.find(CampaignRules.EMPTY, name + " has no values.", part.at("csv"));
    }
    return values.isEmpty() ? NOTHING : values;
  }
}
