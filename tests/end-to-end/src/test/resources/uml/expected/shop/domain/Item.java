package domain;

public abstract class Item {
    private Integer id; // key

}
