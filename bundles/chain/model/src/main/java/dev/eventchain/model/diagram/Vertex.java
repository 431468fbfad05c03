package dev.eventchain.model.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.LineKind;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/** A box during layout, or a part of a line that crosses a layer. */
final class Vertex {

  /** A line during layout; reversed if it would close a cycle. */
  static final class Edge {
    final Vertex from;
    final Vertex to;
    final LineKind kind;
    boolean isReversed;

    /** The parts that cross layers, from the top. */
    final List<Vertex> passes = new ArrayList<>();

    Edge(Vertex from, Vertex to, LineKind kind) {
      this.from = from;
      this.to = to;
      this.kind = kind;
    }

    Vertex upper() {
      return isReversed ? to : from;
    }

    Vertex lower() {
      return isReversed ? from : to;
    }
  }

  /** Null for a part of a line. */
  final Kind kind;

  final List<EObject> elements = new ArrayList<>();
  final String name;

  /** Position in the order of the chain: a topic comes after its last writer. */
  final double rank;

  /** The text below its name. */
  String facts = "";

  boolean isGenerated;
  final List<Edge> out = new ArrayList<>();
  final List<Edge> in = new ArrayList<>();
  List<ChainDiagram.Text> texts = List.of();

  /** Neighbours in the adjacent layers, after lines were split into parts. */
  final List<Vertex> above = new ArrayList<>();

  final List<Vertex> below = new ArrayList<>();

  int layer;
  int position;

  /** The centre. */
  double x;

  int width;

  /** Height of the box without its bars. */
  int height;

  /** The upper side of the box. */
  int y;

  Vertex(Kind kind, String name, double rank) {
    this.kind = kind;
    this.name = name;
    this.rank = rank;
  }

  boolean isPass() {
    return kind == null;
  }

  /** Returns the number of lines that join above the box; upward lines are not counted. */
  int joining() {
    return (int) in.stream().filter(edge -> !edge.isReversed).count();
  }

  /** Returns the number of lines that fork below the box. */
  int forking() {
    return (int) out.stream().filter(edge -> !edge.isReversed).count();
  }

  /** Returns whether a bar is drawn above: the component waits there for all its topics. */
  boolean hasJoin() {
    return kind == Kind.COMPONENT && joining() > 1;
  }

  /** Returns whether a bar is drawn below. */
  boolean hasFork() {
    return !isPass() && forking() > 1;
  }

  int left() {
    return (int) Math.round(x - width / 2.0);
  }
}
