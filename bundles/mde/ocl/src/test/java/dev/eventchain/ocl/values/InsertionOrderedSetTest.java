package dev.eventchain.ocl.values;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests that the change of representation with many elements is not visible outside. */
class InsertionOrderedSetTest {

  private static final List<Object> VALUES =
      Arrays.asList(
          1, 1.0, 2L, "1", "a", null, List.of(1), List.of(1.0), 0.5, "b", 3, 4.0, 5, "c", 6, "d");

  @Test
  void hasTheElementsOfAnOrderedSetWhateverTheirNumber() {
    Random random = new Random(20261123);
    InsertionOrderedSet<Object> set = new InsertionOrderedSet<>();
    ValueSet<Object> reference = new ValueSet<>();
    for (int i = 0; i < 5000; i++) {
      // Long runs of additions and of removals make the set small and large in turns.
      boolean add = random.nextInt(8) != 0 ^ i / 40 % 2 == 0;
      Object value = VALUES.get(random.nextInt(VALUES.size()));
      assertEquals(
          add ? reference.add(value) : reference.remove(value),
          add ? set.add(value) : set.remove(value));
      assertEquals(new ArrayList<>(reference), new ArrayList<>(set));
      assertEquals(reference.hashCode(), set.hashCode());
      VALUES.forEach(each -> assertEquals(reference.contains(each), set.contains(each)));
      assertEquals(new InsertionOrderedSet<>(reference), set);
    }
  }

  @Test
  void leavesAGivenListAsItIs() {
    for (List<Integer> given : List.of(List.of(1, 2), List.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10))) {
      InsertionOrderedSet<Integer> set = InsertionOrderedSet.ofDistinct(given);
      assertTrue(set.contains(2));
      assertFalse(set.add(1));
      assertTrue(set.add(11));
      assertTrue(set.remove(1));
      assertEquals(given.size(), set.size());
      assertEquals(2, set.iterator().next());
      assertEquals(1, given.get(0));
    }
  }
}
