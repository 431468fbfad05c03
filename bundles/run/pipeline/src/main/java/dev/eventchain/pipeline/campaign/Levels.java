package dev.eventchain.pipeline.campaign;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;

/** The values of a factor. */
sealed interface Levels {

  /** Digits of a value that is drawn: more say nothing, and fewer would make doubles. */
  MathContext DIGITS = new MathContext(8, RoundingMode.HALF_EVEN);

  /** Returns the value at a share of all, from 0 to below 1. */
  BigDecimal at(double share);

  /** Returns values that are checked before the campaign begins: all, or the ends. */
  List<BigDecimal> checked();

  /** Values in the order of the file. */
  record Listed(List<BigDecimal> values) implements Levels {

    public Listed {
      values = List.copyOf(values);
    }

    @Override
    public BigDecimal at(double share) {
      return values.get((int) (share * values.size()));
    }

    @Override
    public List<BigDecimal> checked() {
      return values;
    }
  }

  /**
   * The cells of a column, in the order of its table.
   *
   * @param table the name of the file, as the campaign file has it
   */
  record Column(String table, List<BigDecimal> cells) implements Levels {

    public Column {
      cells = List.copyOf(cells);
    }

    @Override
    public BigDecimal at(double share) {
      List<BigDecimal> values = checked();
      return values.get((int) (share * values.size()));
    }

    @Override
    public List<BigDecimal> checked() {
      return cells.stream().distinct().toList();
    }
  }

  /** All values from one to another one, with the same probability. */
  record Uniform(BigDecimal least, BigDecimal most) implements Levels {

    @Override
    public BigDecimal at(double share) {
      BigDecimal part = most.subtract(least).multiply(BigDecimal.valueOf(share));
      return least.add(part).round(DIGITS);
    }

    @Override
    public List<BigDecimal> checked() {
      return List.of(least, most);
    }
  }
}
