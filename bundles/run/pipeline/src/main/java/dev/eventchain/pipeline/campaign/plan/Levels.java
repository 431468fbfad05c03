package dev.eventchain.pipeline.campaign.plan;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import org.hipparchus.distribution.continuous.NormalDistribution;

/** The values of a factor. */
public sealed interface Levels {

  /** Digits of a value that is drawn: more say nothing, and fewer would make doubles. */
  MathContext DIGITS = new MathContext(8, RoundingMode.HALF_EVEN);

  /** Returns the value at a share of all, from 0 to below 1. */
  BigDecimal at(double share);

  /** Returns values that are checked before the campaign begins: all, or the ends. */
  List<BigDecimal> checked();

  /** Returns whether there is no end of values, so that some have to be drawn. */
  default boolean isContinuous() {
    return false;
  }

  /** Returns a value within bounds, which rounding may have left. */
  private static BigDecimal within(BigDecimal value, BigDecimal least, BigDecimal most) {
    return value.max(least).min(most);
  }

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
   * A column of a table.
   *
   * @param table the name of the file, as the campaign file has it
   * @param cells all cells, in their order
   * @param checked the values among them
   */
  record Column(String table, List<BigDecimal> cells, List<BigDecimal> checked) implements Levels {

    Column(String table, List<BigDecimal> cells) {
      this(table, List.copyOf(cells), cells.stream().distinct().toList());
    }

    @Override
    public BigDecimal at(double share) {
      return checked.get((int) (share * checked.size()));
    }
  }

  /** Values between bounds, of which there is no end. */
  sealed interface Bounded extends Levels permits Uniform, Normal {

    BigDecimal least();

    BigDecimal most();

    @Override
    default List<BigDecimal> checked() {
      return List.of(least(), most());
    }

    @Override
    default boolean isContinuous() {
      return true;
    }
  }

  /** All values from one to another one, with the same probability. */
  record Uniform(BigDecimal least, BigDecimal most) implements Bounded {

    @Override
    public BigDecimal at(double share) {
      BigDecimal part = most.subtract(least).multiply(BigDecimal.valueOf(share));
      return within(least.add(part).round(DIGITS), least, most);
    }
  }

  /**
   * Values of a normal distribution that lie within bounds: the others are not there, and these are
   * the likelier for it.
   *
   * @param deviation the standard deviation, without regard to the bounds
   */
  record Normal(BigDecimal mean, BigDecimal deviation, BigDecimal least, BigDecimal most)
      implements Bounded {

    private static final NormalDistribution STANDARD = new NormalDistribution();

    /** The part of all values that has to lie within the bounds. */
    private static final double LEAST_MASS = 1e-9;

    boolean hasMass() {
      return share(upper()) - share(lower()) >= LEAST_MASS;
    }

    @Override
    public BigDecimal at(double share) {
      // Above the mean, shares are too close to 1 to be told apart: the other side is the same.
      boolean isAbove = lower() > 0.0;
      double from = isAbove ? share(-lower()) : share(lower());
      double to = isAbove ? share(-upper()) : share(upper());
      double deviations = STANDARD.inverseCumulativeProbability(from + share * (to - from));
      double value =
          mean.doubleValue() + (isAbove ? -deviations : deviations) * deviation.doubleValue();
      double inside = Math.max(least.doubleValue(), Math.min(most.doubleValue(), value));
      return within(BigDecimal.valueOf(inside).round(DIGITS), least, most);
    }

    private static double share(double deviations) {
      return STANDARD.cumulativeProbability(deviations);
    }

    private double lower() {
      return least.subtract(mean).doubleValue() / deviation.doubleValue();
    }

    private double upper() {
      return most.subtract(mean).doubleValue() / deviation.doubleValue();
    }
  }
}
