package dev.eventchain.eclipse.diagram;

import dev.eventchain.eclipse.diagram.ChainDiagram.Kind;
import dev.eventchain.eclipse.diagram.ChainDiagram.LineKind;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/** A box on its way to its place, or a part of a line that passes a layer. */
final class Vertex {

  /** A line on its way; the layout turns it round where it would close a cycle. */
  static final class Edge {
    final Vertex from;
    final Vertex to;
    final LineKind kind;
    boolean isReversed;

    /** The parts that pass layers, from the top. */
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

  /** The place in the order of the chain: a topic comes after the last that writes it. */
  final double rank;

  /** What it says below its name. */
  String facts = "";

  boolean isGenerated;
  final List<Edge> out = new ArrayList<>();
  final List<Edge> in = new ArrayList<>();
  List<ChainDiagram.Text> texts = List.of();

  /** Neighbours in the layers next to this one, once lines are cut into parts. */
  final List<Vertex> above = new ArrayList<>();

  final List<Vertex> below = new ArrayList<>();

  int layer;
  int position;

  /** The middle. */
  double x;

  int width;

  /** Of the box without its bars. */
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

  /** How many lines join above the box; those that lead upwards are apart. */
  int joining() {
    return (int) in.stream().filter(edge -> !edge.isReversed).count();
  }

  /** How many lines fork below the box. */
  int forking() {
    return (int) out.stream().filter(edge -> !edge.isReversed).count();
  }

  /** Whether a bar is drawn above: a component waits there for all its topics. */
  boolean hasJoin() {
    return kind == Kind.COMPONENT && joining() > 1;
  }

  /** Whether a bar is drawn below. */
  boolean hasFork() {
    return !isPass() && forking() > 1;
  }

  int left() {
    return (int) Math.round(x - width / 2.0);
  }
}
