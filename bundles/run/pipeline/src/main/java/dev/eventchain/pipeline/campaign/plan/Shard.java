package dev.eventchain.pipeline.campaign.plan;

/**
 * A part of a campaign: every {@code count}th combination, from the {@code number}th on.
 *
 * @param number from 1
 */
public record Shard(int number, int count) {

  /** The whole campaign. */
  public static final Shard ALL = new Shard(1, 1);

  /**
   * Reads {@code 2/5}.
   *
   * @throws IllegalArgumentException with the reason, for users
   */
  public static Shard parse(String text) {
    if (!text.matches("[1-9]\\d{0,5}/[1-9]\\d{0,5}")) {
      throw new IllegalArgumentException("a part is a number of all, such as --shard 2/5");
    }
    String[] parts = text.split("/", -1);
    Shard shard = new Shard(Integer.parseInt(parts[0]), Integer.parseInt(parts[1]));
    if (shard.number > shard.count) {
      throw new IllegalArgumentException("there is no part " + text);
    }
    return shard;
  }

  /** Returns whether it is the whole campaign. */
  public boolean coversAll() { // as isAll, it would be a property in JSON
    return count == 1;
  }

  /** Returns whether it has what is at an index, from 0. */
  public boolean has(int index) {
    return numberOf(index, count) == number;
  }

  /** Returns the number of the part that has what is at an index. */
  public static int numberOf(int index, int count) {
    return index % count + 1;
  }

  /** Returns the name of the folder of a campaign's results. */
  public String folder(String campaign) {
    return coversAll() ? campaign : campaign + "-" + number + "-of-" + count;
  }
}
