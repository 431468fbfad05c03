package dev.eventchain.pipeline;

import java.util.List;
import java.util.stream.Stream;

/**
 * A rule about a feature {@code $} that contains Targets, and Targets that satisfy it, violate it
 * or give no value: their marks, or {@code -} for none; cases are separated by bars. A mark of ten
 * or more is that of a Special; the colour of a Target depends on its mark.
 */
record PlantedRule(String text, String satisfying, String violating, String undefined) {

  /** Rules about at most one Target. */
  static final List<PlantedRule> OF_ONE =
      List.of(
          rule("$.mark > 5", "6|9", "1|5", "-"),
          rule("$ <> null", "3", "-"),
          rule("not $.oclIsUndefined()", "4", "-"),
          rule("$ <> null implies $.mark < 4", "-|2", "7"),
          rule("$->isEmpty() or $.mark = 4", "-|4", "5"),
          rule("$->notEmpty()", "1", "-"),
          rule("$->forAll(t | t.mark > 3)", "-|4", "3"),
          rule("self.$->size() = 1", "4|10", "-"),
          rule("$.colour = a::sub::Colour::GREEN", "1|4", "2|3", "-"),
          rule("$.oclIsKindOf(b::Special)", "10|12", "3"),
          rule("$.oclIsTypeOf(a::Target)", "1|2", "10"),
          rule("$.oclAsType(b::Special).mark > 10", "12", "10", "3"),
          rule("Set{1, 2, 3}->includes($.mark)", "2", "5", "-"),
          rule("if $ = null then true else self.$.mark > 5 endif", "-|6", "2"),
          rule("let m : Integer = $.mark in m * 2 > 10", "6", "5", "-"),
          rule("a::Target.allInstances()->exists(t | t = self.$)", "1|11", "-"));

  /** Rules about any number of unordered Targets. */
  static final List<PlantedRule> OF_MANY =
      List.of(
          rule("$->forAll(mark > 5)", "-|6 7|9", "6 1|2"),
          rule("$->forAll(x, y | x <> y implies x.mark <> y.mark)", "-|1 2|4", "1 1"),
          rule("$->exists(x | x.mark > 5)", "9|1 7", "-|1 5"),
          rule("self.$->select(mark > 5)->size() = 2", "6 1 7|8 9", "-|6|6 7 8"),
          rule("$.mark->sum() > 10", "9 2|4 5 6", "-|10|3 4"),
          rule("$->collect(mark)->includes(4)", "1 4|4", "-|5 6"),
          rule("$->isUnique(mark)", "-|3|1 2", "1 1|2 5 2"),
          rule("$->selectByKind(b::Special)->notEmpty()", "10|1 11", "-|1 2"),
          rule("$->selectByType(a::Target)->isEmpty()", "-|10 11", "1|10 2"),
          rule("$->reject(oclIsKindOf(b::Special))->isEmpty()", "-|10 11", "1|10 2"),
          rule("$->one(mark = 3)", "1 3|3", "-|3 3|1"),
          rule("$.colour->asSet() = Set{a::sub::Colour::RED}", "3|6 9", "-|1|3 4"),
          rule("$->iterate(t; n : Integer = 0 | n + t.mark) = 6", "1 5|6|1 2 3", "-|7"),
          rule("$->collect(t | Tuple{m : Integer = t.mark})->exists(m > 5)", "6|1 8", "-|2"),
          rule("$->size() <= 2", "-|1|1 2", "1 2 3"),
          rule("a::Target.allInstances()->includesAll($)", "-|1 10", ""),
          rule("$->any(mark > 5).mark = 7", "7|1 7", "8|2 9", "-|1"),
          rule("$->sortedBy(mark)->first().mark > 3", "9 4|5", "5 1", "-"),
          rule("$->sortedBy(-mark)->collect(mark)->first() = 9", "1 9|9 2", "8|10 9", "-"),
          rule("$.mark->asSequence()->max() < 6", "5|1 2", "6|1 7", "-"),
          rule("$->asSet()->closure(t | $)->size() = 3", "1 2 3", "-|1 2"));

  /** Rules about any number of ordered Targets. */
  static final List<PlantedRule> OF_SEVERAL =
      List.of(
          rule("$->at(1).mark > 5", "6|7 1", "1 6|3", "-"),
          rule("$->last().mark > 5", "6|1 7", "6 1|3", "-"),
          rule("$->first().colour <> a::sub::Colour::BLUE", "1|3 2", "2 3|5", "-"),
          rule("$->indexOf($->any(mark = 4)) = 2", "1 4|2 4 3", "4 1|1 2 4"),
          rule("$.mark = Sequence{1, 2}", "1 2", "2 1|-|1|1 2 2"),
          rule("$->subOrderedSet(1, 2)->forAll(mark < 4)", "1 2 9|3 3", "1 9 2|9 1", "-|1"));

  private static PlantedRule rule(String text, String satisfying, String violating) {
    return rule(text, satisfying, violating, "");
  }

  private static PlantedRule rule(
      String text, String satisfying, String violating, String undefined) {
    return new PlantedRule(text, satisfying, violating, undefined);
  }

  String about(String feature) {
    return text.replace("$", feature);
  }

  /** Returns the marks of the Targets in each case. */
  static List<List<Integer>> cases(String text) {
    return text.isEmpty()
        ? List.of()
        : Stream.of(text.split("\\|")).map(PlantedRule::marks).toList();
  }

  private static List<Integer> marks(String text) {
    return text.equals("-") ? List.of() : Stream.of(text.split(" ")).map(Integer::valueOf).toList();
  }
}
