"""Small lattices of each rule whose Markov chain can be worked out, drawn in the rule's letters as they lie."""

LATTICES = {
    "water-and-oil": {
        "sand over water": ("ss..", "ww..", "ww.."),
        "oil below water": ("w.w", "ow.", "oo.", "..."),
        "all three": ("sw..", "wo..", "so#.", "...."),
        "sinking by columns": ("s#s", "w#o", "o#w", "w#o"),
        "column of water": ("w....", "w....", "w....", "##.#."),
    },
    "three-sands": {
        "towers": ("fcs..", "fcs..", "fcs..", "....."),
        "coarse on fine": ("cc..", "ff..", "ss..", "...."),
        "mixed columns": ("c#sc", "s#fs", "f#ff", ".#.."),
        "step": ("fsc..", "cfs..", "##s..", "##.#."),
    },
    "rolling-sand": {
        "tower": ("..o...", "..o...", "..o...", "..o..."),
        "rolling on": ("ro...", "oo...", "##.#."),
        "block": (".oo..", ".oo..", ".oo..", "....."),
        "neck": ("oo#oo", "#o.o#", "##.##", "....."),
    },
    "two-sands": {
        "towers": (".s.o.", ".s.o.", ".s.o.", "....."),
        "pairs": ("ss.oo", "os.oo", ".....", "#...."),
        "grains on sand": ("oo..", "ss..", "so..", "...."),
    },
    "alchemy": {
        "fire in plants": ("fp.", "pep", "..."),
        "fire put out": ("fw", "bf", "if", ".o"),
        "oil burns": ("fo.", "oo.", "..m"),
        "lava in water": ("lw", "wl", "#."),
        "lava and brine": ("b.b", "l#l", "..."),
        "lava and what burns": ("li.", "lop", ".e."),
        "ice": ("iw.", "it.", "xi."),
        "steam below stone": ("#k.", "t.t", "#w."),
        "salt in water": ("x.x", "ww.", "bw."),
        "acid": ("as.", "kap", "e.l"),
        "acid in water": ("aw.", "wa."),
        "garden": ("w.w", "pew", "ps."),
        "smoke and steam": ("s..", "m.t", "t.m"),
        "powders": ("kx..", "se..", "...."),
    },
}
