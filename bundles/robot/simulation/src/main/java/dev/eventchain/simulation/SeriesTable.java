package dev.eventchain.simulation;

import dev.eventchain.documents.CsvText;
import dev.eventchain.simulation.verdict.Curve;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Series;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes the curves of a scenario as a table (RFC 4180): a column for the time and each curve, with
 * its unit in brackets, and a row every 50 ms. A cell is empty where a curve has no value.
 */
final class SeriesTable {

  private SeriesTable() {}

  /** Returns the content of the file, in UTF-8. */
  static byte[] write(Series series) {
    CsvText table = new CsvText("\r\n");
    List<String> headings = new ArrayList<>(List.of("time [s]"));
    series.curves().forEach(curve -> headings.add(heading(curve)));
    table.row(headings);
    for (int i = 0; i < series.time().size(); i++) {
      List<String> cells = new ArrayList<>();
      cells.add(MeasurementsTable.number(series.time().get(i)));
      for (Curve curve : series.curves()) {
        boolean has = i < curve.values().size();
        cells.add(has ? cell(curve, curve.values().get(i)) : "");
      }
      table.row(cells);
    }
    return table.bytes();
  }

  private static String cell(Curve curve, double value) {
    return curve.nameOf(value).orElseGet(() -> MeasurementsTable.number(value));
  }

  private static String heading(Curve curve) {
    return curve.unit().isEmpty() || curve.unit().equals("1")
        ? curve.name()
        : curve.name() + " [" + curve.unit() + "]";
  }
}
