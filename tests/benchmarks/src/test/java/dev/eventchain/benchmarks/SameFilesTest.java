package dev.eventchain.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.templates.ShippedTemplates;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that the compared template benchmarks generate the same files. */
class SameFilesTest {

  @Test
  void thePapersTemplate() {
    EventChain chain = NodeTemplates.chain(100);
    var generated = NodeTemplates.generate(NodeTemplates.compile(), chain).files();
    assertEquals(100, generated.size());
    assertEquals(Optional.empty(), NodeTemplates.difference(generated, NodeFiles.of(chain)));
  }

  @ParameterizedTest
  @MethodSource("sets")
  void eachShippedSetHasFilesForEachNode(String set) {
    var module = TemplateSets.compile(set);
    int one = NodeTemplates.generate(module, NodeTemplates.chain(1)).files().size();
    int ten = NodeTemplates.generate(module, NodeTemplates.chain(10)).files().size();
    assertTrue(ten >= one + 9, one + " files for one node, " + ten + " for ten");
  }

  static Iterable<String> sets() {
    return ShippedTemplates.sets();
  }
}
