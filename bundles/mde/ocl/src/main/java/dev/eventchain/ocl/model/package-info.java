/**
 * Access to models: contents, extents, features, operations and instances of types. Independent of
 * expressions.
 */
package dev.eventchain.ocl.model;
